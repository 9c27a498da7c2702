"""Deals the shards of a question to Dask workers and merges what they have written.

    python dask_shards.py QUESTION FOLDER --shards 30                                  # on this machine
    python dask_shards.py QUESTION FOLDER --shards 300 --scheduler tcp://head:8786     # on a cluster

A task is a shard, never a run: a shard is worth seconds of work at least, and what a scheduler costs is paid once for each. Workers need the package
`formicarium`, and the question, its maps and the folder under the same names as here. A shard that was broken off goes on where it was, so that
retrying one, or starting all of this again, repeats nothing that is done.
"""

from __future__ import annotations

import argparse
import os
import shlex
import subprocess
import sys
import time

from dask.distributed import Client, LocalCluster, as_completed


def do_shard(arguments: list[str]) -> float:
    """Does one shard on a worker, and tells how many seconds it took; what is not whole is an error, which Dask retries."""
    import formicarium

    begun = time.monotonic()
    code = formicarium.command(arguments)
    if code != 0:
        raise RuntimeError(f"`formicarium {' '.join(arguments)}` ended with exit code {code}")
    return time.monotonic() - begun


def journals_of(options: argparse.Namespace) -> str:
    """The folder of the journals, which is called by the digest of question and maps: another question begins anew."""
    command = [sys.executable, "-m", "formicarium", "compare", options.question, *options.options, "--list-shards", "1"]
    listed = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    if listed.returncode != 0:
        sys.exit(listed.returncode)
    # NAME.DIGEST.shard-1of1.journal
    return os.path.join(options.folder, "shards", listed.stdout.strip().split(".")[-3])


def deal(client: Client, options: argparse.Namespace) -> list[int]:
    """Has every shard done, tells of each that ends, and gives those that failed more often than they may."""
    compare = ["compare", options.question, *options.options, "--out", journals_of(options)]
    compare += [] if options.jobs is None else ["--jobs", str(options.jobs)]
    futures = {
        client.submit(do_shard, [*compare, "--shard", f"{number}/{options.shards}"], retries=options.retries, pure=False): number
        for number in range(1, options.shards + 1)
    }
    failed = []
    for ended, future in enumerate(as_completed(futures), 1):
        number = futures[future]
        if future.status == "finished":
            said = f"done in {future.result():.1f} s"
        else:
            failed.append(number)
            said = f"failed: {future.exception()}"
        print(f"shard {number}/{options.shards} {said} ({ended} of {options.shards} ended)", flush=True)
    return sorted(failed)


def main() -> int:
    """Reads the arguments, has the shards done, and merges them. Exit code 0 when the results are written."""
    parser = argparse.ArgumentParser(description="Deals the shards of a question to Dask workers and merges them.")
    parser.add_argument("question", type=os.path.abspath, help="the question's file, under a name that the workers know too")
    parser.add_argument("folder", type=os.path.abspath, help="where shards/ and results/ go, known to the workers too")
    parser.add_argument("--shards", type=int, default=2 * (os.cpu_count() or 1), help="how many [default: two a core]")
    parser.add_argument("--options", type=shlex.split, default=[], help='more of `compare` on which runs depend: "--seeds 10"')
    parser.add_argument("--recheck", metavar="P%%", help="repeat this part of the runs in the end, such as 2%%")
    parser.add_argument("--retries", type=int, default=2, help="how often a shard is begun again [default: 2]")
    parser.add_argument("--jobs", type=int, help="threads of a shard [default: with --scheduler a worker's cores, else 1]")
    parser.add_argument("--scheduler", help="address of a Dask scheduler [default: workers on this machine]")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1, help="workers on this machine [default: one a core]")
    options = parser.parse_args()
    if options.scheduler is None and options.jobs is None:
        options.jobs = 1
    here = None
    if options.scheduler is None:
        here = LocalCluster(n_workers=options.processes, threads_per_worker=1, processes=True, dashboard_address=None)
    with Client(here or options.scheduler) as client:
        failed = deal(client, options)
    if here is not None:
        here.close()
    if failed:
        print(f"not merged: the shards {', '.join(map(str, failed))} are missing; start this again to do them", file=sys.stderr)
        return 1
    import formicarium

    results = os.path.join(options.folder, "results")
    merge = ["compare", options.question, *options.options, "--merge", journals_of(options), "--out", results]
    return formicarium.command(merge + (["--recheck", options.recheck] if options.recheck else []))


if __name__ == "__main__":
    sys.exit(main())
