"""What happens before a page runs: the settings of the server, packed files, start page, headers and cookies."""
