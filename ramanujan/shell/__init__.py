"""Modules that all pages share: navigation, sidebar, address, messages, theme, display mode, class session, server."""
