"""What an earlier build has left: dangling links, and files that are no longer installed."""

from __future__ import annotations

from pathlib import Path

from tests.workspace.conftest import write_files

from tfloom.workspace.leftovers import RECORD, remove_dangling_links, remove_former_files


def test_dangling_links_are_removed_and_others_stay(tmp_path: Path) -> None:
    write_files(tmp_path, {"there": "", "links/file": "", "links/deep/file": ""})
    for name, target in (("good", "there"), ("bad", "gone"), ("deep/bad", "gone"), ("folder", "links/deep")):
        (tmp_path / "links" / name).symlink_to(tmp_path / target)
    remove_dangling_links([tmp_path / "links", tmp_path / "none"])
    assert not (tmp_path / "links" / "bad").is_symlink()
    assert not (tmp_path / "links" / "deep" / "bad").is_symlink()
    assert all((tmp_path / "links" / name).exists() for name in ("file", "good", "folder", "deep/file"))


def test_files_that_are_no_longer_installed_are_removed(tmp_path: Path) -> None:
    prefix, build = tmp_path / "install", tmp_path / "build"
    write_files(tmp_path, {"install/a/old": "", "install/b/old": "", "install/b/new": "", "other/old": ""})
    old = [prefix / "a" / "old", prefix / "b" / "old", tmp_path / "other" / "old"]
    remove_former_files(build, prefix, old)
    assert all(path.exists() for path in old)
    remove_former_files(build, prefix, [prefix / "b" / "new"])
    assert [path.exists() for path in old] == [False, False, True]
    assert not (prefix / "a").exists()
    assert (prefix / "b" / "new").exists()
    assert (build / RECORD).read_text() == f"{prefix}/b/new\n"
