"""Where shards are kept, and what is made of them."""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
import uuid


def is_local(place):
    """Whether a place is a path, and no address of fsspec."""
    return "://" not in os.fspath(place)


@contextlib.contextmanager
def written(place, options=None):
    """A local path for a file that then is where it belongs: at a path, or an address of fsspec."""
    place = os.fspath(place)
    if is_local(place):
        yield place
        return
    above, name = place.rsplit("/", 1)
    with Parts(above, options).writing(name) as path:
        yield path


class Parts:
    """A folder of shards: a local path, or any store that fsspec knows."""

    def __init__(self, place, options=None):
        self.place = os.fspath(place)
        self.options = options or {}
        self.is_local = is_local(self.place)

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

    @contextlib.contextmanager
    def writing(self, name):
        """A local path for a file that then gets its place in the folder: there is all of it or nothing."""
        own = f".{uuid.uuid4().hex}.{name}"
        if self.is_local:
            os.makedirs(self.place, exist_ok=True)
            beside = os.path.join(self.place, own)
            try:
                yield beside
                with open(beside, "rb") as file:
                    os.fsync(file.fileno())
                os.replace(beside, os.path.join(self.place, name))
            finally:
                with contextlib.suppress(FileNotFoundError):
                    os.remove(beside)
            return
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, name)
            yield path
            store, root = self._store()
            store.makedirs(root, exist_ok=True)
            store.put_file(path, f"{root}/{own}")
            store.mv(f"{root}/{own}", f"{root}/{name}")

    def write(self, name, data):
        with self.writing(name) as path, open(path, "wb") as file:
            file.write(data)

    def fetch(self, names, folder):
        """Local paths of files in the folder."""
        if self.is_local:
            return [os.path.join(self.place, name) for name in names]
        store, root = self._store()
        paths = [os.path.join(folder, name) for name in names]
        store.get([f"{root}/{name}" for name in names], paths)
        return paths

    def remove(self):
        if self.is_local:
            shutil.rmtree(self.place)
        else:
            store, root = self._store()
            store.rm(root, recursive=True)
