# SPDX-License-Identifier: MIT
"""What a machine's folder of records holds, and on which host a file was recorded."""


def sources_in(folder):
    """Yields (name, the files of each process) for each record in the folder. One process: NAME.json or NAME/*.json;
    several: NAME/1.json ... or NAME/1/*.json ..."""
    for path in sorted(folder.glob("[!.]*"), key=lambda path: (path.is_dir(), path.name)):
        if path.is_dir():
            numbered = sorted((inner for inner in path.iterdir() if inner.stem.isdigit() and
                               (inner.is_dir() or inner.suffix == ".json")), key=lambda inner: int(inner.stem))
            runs = [sorted(inner.glob("*.json")) if inner.is_dir() else [inner] for inner in numbered]
            yield path.name if path.name.startswith("sweep") else f"{path.name}.json", runs or [sorted(path.glob("*.json"))]
        elif path.suffix == ".json":
            yield path.name, [[path]]


def host_of(root):
    """The CPU of one file's host, with the threads that its backend had, or all where it was not timed."""
    if "context" not in root:
        return "not named by the record"
    machine = root["context"].get("machine", {})
    own = [backend["details"]["threads"] for backend in root.get("backends", ()) if isinstance(backend, dict) and
           backend.get("name") == "cpu" and "threads" in backend.get("details", {})]
    threads = f"{own[0]} threads" if own else f"{machine.get('hardware_threads', 'unknown')} hardware threads"
    return f"{machine.get('cpu', 'unknown').replace('(R)', '')}, {threads}"
