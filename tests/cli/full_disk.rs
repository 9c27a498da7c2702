//! A disk that is full, at every write. It takes a file system of its own, and so the rights to mount one.
#![cfg(target_os = "linux")]

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::Command;

use super::folder::Folder;

/// A small file system in memory.
struct Disk(PathBuf);

impl Disk {
    /// None, said, where it cannot be mounted.
    fn mount(folder: &Folder) -> Option<Self> {
        let path = folder.0.join("disk");
        std::fs::create_dir_all(&path).unwrap();
        let mounted = Command::new("mount").args(["-t", "tmpfs", "-o", "size=1m", "tmpfs"]).arg(&path).output();
        if mounted.is_ok_and(|ran| ran.status.success()) {
            return Some(Self(path));
        }
        println!("skipped: no file system can be mounted here");
        None
    }

    /// Leaves about so many KiB. The system may give back the space of a file that was deleted a little later, so that
    /// more than that is free afterwards: a test must not rest on it, but for no KiB, where another look is taken.
    fn fill(&self, free: usize) {
        let length = self.take_all("filler");
        let filler = std::fs::OpenOptions::new().write(true).open(self.0.join("filler")).unwrap();
        filler.set_len(length.saturating_sub(1024 * free as u64)).unwrap();
        if free == 0 {
            let mut lengths =
                (0..100).map(|_| self.take_all("filler")).scan(length, |last, next| Some(next == std::mem::replace(last, next)));
            assert!(lengths.any(|same| same), "the disk does not stay full");
        }
    }

    /// Lets a file grow until nothing more can be written; its bytes.
    fn take_all(&self, name: &str) -> u64 {
        use std::io::Write;
        let mut file = std::fs::OpenOptions::new().append(true).create(true).open(self.0.join(name)).unwrap();
        while file.write_all(&[0; 4096]).is_ok() {}
        file.metadata().unwrap().len()
    }

    fn free(&self) {
        std::fs::remove_file(self.0.join("filler")).unwrap();
    }

    /// Every file but the filler and the journal.
    fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let entries = std::fs::read_dir(&self.0).unwrap().map(Result::unwrap);
        let files = entries.map(|e| (e.file_name().to_string_lossy().into_owned(), std::fs::read(e.path()).unwrap()));
        files.filter(|(name, _)| name != "filler" && !name.ends_with(".partial")).collect()
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(&self.0).status();
    }
}

#[test]
fn compare_loses_nothing_and_goes_on_when_there_is_space_again() {
    let folder = Folder::with_question("full-compare");
    let Some(disk) = Disk::mount(&folder) else { return };
    let new = ["q.toml", "--out", "disk", "--seeds", "20"];
    assert_eq!(folder.compare(&new).0, 0);
    let wanted = disk.files();
    let mut failures = 0;
    for free in (0..200).step_by(4) {
        // The results of fewer runs, which are to be replaced.
        assert_eq!(folder.compare(&["q.toml", "--out", "disk", "--seeds", "2"]).0, 0);
        let old = disk.files();
        disk.fill(free);
        let (code, said) = folder.compare(&new);
        let found = disk.files();
        assert_eq!(found.keys().collect::<Vec<_>>(), wanted.keys().collect::<Vec<_>>(), "{free} KiB: {said}");
        assert!(found.iter().all(|(name, bytes)| *bytes == old[name] || *bytes == wanted[name]), "{free} KiB: half a file");
        assert!(code == 0 || (code == 2 && said.contains("No space left")), "{free} KiB: {code} {said}");
        failures += usize::from(code != 0);
        disk.free();
        let (code, said) = folder.compare(&new);
        assert!(code == 0 && disk.files() == wanted, "{free} KiB: {said}");
        assert!(!disk.0.join("q.partial").exists());
    }
    assert!(failures > 5, "{failures} failures");
    println!("compare: {failures} of 50 disks were too small");
}

#[test]
fn convert_and_generate_leave_the_old_file() {
    let folder = Folder::with_map("full-convert");
    let Some(disk) = Disk::mount(&folder) else { return };
    folder.run(&["generate", "cave", "--size", "120x90", "--out", "large.map"]).ends(0);
    for command in [
        &["convert", "large.map", "disk/a.csv"][..],
        &["convert", "large.map", "disk/a.json"],
        &["generate", "hills", "--size", "160x160", "--out", "disk/a.tif"],
    ] {
        let name = command.last().unwrap();
        let bytes = || std::fs::read(folder.0.join(name)).unwrap();
        folder.run(command).ends(0);
        let wanted = bytes();
        for free in [0, 4, 8] {
            folder.write(name, "the old one\n");
            disk.fill(free);
            let ran = folder.run(command);
            if ran.code == 0 && free > 0 {
                assert_eq!(bytes(), wanted, "{free} KiB: said to be written");
            } else {
                let ran = ran.ends(2).says(&["No space left"]);
                assert!(ran.err.contains(name) && !ran.err.contains(".tmp"), "{}", ran.err);
                assert_eq!(folder.read(name), "the old one\n");
            }
            assert_eq!(disk.files().len(), 1, "something else was left");
            disk.free();
        }
        folder.run(command).ends(0);
        assert_eq!(bytes(), wanted);
        std::fs::remove_file(folder.0.join(name)).unwrap();
    }
}
