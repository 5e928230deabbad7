"""Writing of bags: records, files of both storages, and folders of files with their metadata."""
