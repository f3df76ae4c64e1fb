"""Where shards are kept."""

from __future__ import annotations

import os
import shutil
import tempfile
import uuid


class Parts:
    """A folder of shards: a local path, or any store that fsspec knows."""

    def __init__(self, place, options=None):
        self.place = os.fspath(place)
        self.options = options or {}
        self.is_local = "://" not in self.place

    def _store(self):
        import fsspec  # type: ignore

        return fsspec.core.url_to_fs(self.place, **self.options)

    def names(self):
        """The names of the files in the folder."""
        if self.is_local:
            return set(os.listdir(self.place)) if os.path.isdir(self.place) else set()
        store, root = self._store()
        if not store.exists(root):
            return set()
        store.invalidate_cache()
        return {found.rstrip("/").rsplit("/", 1)[-1] for found in store.ls(root, detail=False)}

    def read(self, name):
        if self.is_local:
            with open(os.path.join(self.place, name), "rb") as file:
                return file.read()
        store, root = self._store()
        return store.cat_file(f"{root}/{name}")

    def put(self, local, name):
        """Gives a local file its place in the folder: there is all of it or nothing."""
        own = f".{name}.{uuid.uuid4().hex}"
        if self.is_local:
            os.makedirs(self.place, exist_ok=True)
            beside = os.path.join(self.place, own)
            shutil.copyfile(local, beside)
            with open(beside, "rb") as file:
                os.fsync(file.fileno())
            os.replace(beside, os.path.join(self.place, name))
            return
        store, root = self._store()
        store.makedirs(root, exist_ok=True)
        store.put_file(local, f"{root}/{own}")
        store.mv(f"{root}/{own}", f"{root}/{name}")

    def write(self, name, data):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, name)
            with open(path, "wb") as file:
                file.write(data)
            self.put(path, name)

    def fetch(self, names, folder):
        """Local paths of files in the folder."""
        if self.is_local:
            return [os.path.join(self.place, name) for name in names]
        store, root = self._store()
        paths = [os.path.join(folder, name) for name in names]
        for name, path in zip(names, paths, strict=True):
            store.get_file(f"{root}/{name}", path)
        return paths

    def remove(self):
        if self.is_local:
            shutil.rmtree(self.place)
        else:
            store, root = self._store()
            store.rm(root, recursive=True)
