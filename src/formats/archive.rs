//! ZIP and gzip archives: what is within, if it is not too much.

use std::io::{Cursor, Read};

use flate2::read::MultiGzDecoder;
use zip::ZipArchive;

use super::recognise::recognise;
use super::{Companion, Imported, Kind, MAX_BYTES, ReadOptions, import_with, ros};
use crate::comparison::names::file_name;
use crate::error::{Error, FormatError, Notice};

/// Most files of an archive that are looked at.
const MAX_FILES: usize = 1000;

/// A file with its name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedFile {
    /// Its name, perhaps with folders.
    pub name: String,
    /// What it holds.
    pub bytes: Vec<u8>,
}

/// The files of an archive, without folders and what systems put beside them; all together at most 512 MiB.
///
/// # Errors
/// [`FormatError::Field`]: the archive is broken, or locked by a password; [`FormatError::TooLarge`]: it holds more.
pub fn unpack(bytes: &[u8], name: &str) -> Result<Vec<NamedFile>, FormatError> {
    if bytes.starts_with(b"\x1f\x8b") {
        let mut left = MAX_BYTES as u64;
        let unpacked = bounded(MultiGzDecoder::new(bytes), &mut left, "gzip")?;
        let inner = name.strip_suffix(".gz").unwrap_or(name);
        return Ok(vec![NamedFile { name: inner.into(), bytes: unpacked }]);
    }
    let broken =
        |e: zip::result::ZipError| FormatError::field("ZIP", e.to_string(), "a ZIP archive that is whole, without a password");
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(broken)?;
    if archive.len() > MAX_FILES {
        let what = format!("an archive of {} files", archive.len());
        return Err(FormatError::TooLarge { what, max: format!("{MAX_FILES} files") });
    }
    let mut left = MAX_BYTES as u64;
    let mut files = Vec::new();
    for index in 0..archive.len() {
        let file = archive.by_index(index).map_err(broken)?;
        let name = file.name().map_err(broken)?.into_owned();
        let is_aside = file.is_dir() || name.starts_with("__MACOSX/") || file_name(&name).starts_with('.');
        if !is_aside {
            files.push(NamedFile { name, bytes: bounded(file, &mut left, "ZIP")? });
        }
    }
    Ok(files)
}

/// Everything that a reader gives, if it is no more than what is left.
fn bounded(reader: impl Read, left: &mut u64, field: &'static str) -> Result<Vec<u8>, FormatError> {
    let mut bytes = Vec::new();
    let read = reader.take(*left + 1).read_to_end(&mut bytes);
    read.map_err(|e| FormatError::field(field, e.to_string(), "an archive that is whole"))?;
    let too_large = || FormatError::TooLarge { what: "what the archive holds".into(), max: format!("{} MiB", MAX_BYTES >> 20) };
    *left = left.checked_sub(bytes.len() as u64).ok_or_else(too_large)?;
    Ok(bytes)
}

/// Reads the one map of an archive: a single file that holds one, or the description of a ROS map with its picture.
///
/// # Errors
/// As [`import_with`]; [`FormatError::Ambiguous`] for more than one map, [`FormatError::NotAMap`] for none.
pub(super) fn import_archive(bytes: &[u8], name: &str, options: &ReadOptions) -> Result<Imported, Error> {
    let files = unpack(bytes, name)?;
    let one = only(&files)?;
    let beside = companion_of(one, &files)?;
    let mut imported = import_with(&one.bytes, &one.name, options, beside)?;
    let message = format!("`{}` was read from the archive", file_name(&one.name));
    imported.notices.insert(0, Notice::new("archive", message).with("name", file_name(&one.name)));
    Ok(imported)
}

/// The file of an archive that is meant.
///
/// # Errors
/// [`FormatError::Ambiguous`], [`FormatError::NotAMap`].
pub(super) fn only(files: &[NamedFile]) -> Result<&NamedFile, FormatError> {
    let known = |file: &&NamedFile| recognise(&file.bytes, &file.name).is_ok_and(|found| found.kind.holds_cells());
    let maps: Vec<&NamedFile> = files.iter().filter(known).collect();
    let descriptions: Vec<&NamedFile> = maps.iter().copied().filter(|file| is_description(file)).collect();
    match (&descriptions[..], &maps[..]) {
        ([one], _) | ([], [one]) => Ok(one),
        ([], []) => Err(FormatError::NotAMap { found: "an archive without a map" }),
        (several, maps) => {
            let several = if several.is_empty() { maps } else { several };
            let names: Vec<_> = several.iter().take(6).map(|file| file_name(&file.name)).collect();
            Err(FormatError::Ambiguous { found: names.join(", ") })
        }
    }
}

fn is_description(file: &NamedFile) -> bool {
    recognise(&file.bytes, &file.name).is_ok_and(|found| found.kind == Kind::RosMap)
}

/// The picture of a ROS map among the files that came with it, by its name without folders.
///
/// # Errors
/// [`FormatError`]: the description cannot be used.
pub(super) fn companion_of<'a>(file: &NamedFile, files: &'a [NamedFile]) -> Result<Option<Companion<'a>>, Error> {
    if !is_description(file) {
        return Ok(None);
    }
    let wanted = ros::image_of(&file.bytes)?;
    let found = files.iter().find(|other| file_name(&other.name).eq_ignore_ascii_case(file_name(&wanted)));
    Ok(found.map(|other| Companion { name: &other.name, bytes: &other.bytes }))
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use flate2::{Compression, write::GzEncoder};
    use zip::ZipWriter;
    use zip::write::SimpleFileOptions;

    use super::*;

    fn zipped(files: &[(&str, &[u8])]) -> Vec<u8> {
        let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
        for (name, bytes) in files {
            zip.start_file(*name, SimpleFileOptions::default()).unwrap();
            zip.write_all(bytes).unwrap();
        }
        zip.finish().unwrap().into_inner()
    }

    fn import(bytes: &[u8], name: &str) -> Result<Imported, String> {
        import_archive(bytes, name, &ReadOptions::default()).map_err(|error| error.to_string())
    }

    #[test]
    fn one_map_is_read_and_several_are_named() {
        let (map, other) = (&b"0 1\n0 0\n"[..], &b"0 0\n1 0\n"[..]);
        let one = import(&zipped(&[("a/", b""), ("a/map.txt", map), ("__MACOSX/map.txt", other), ("a/.hidden", other)]), "x.zip");
        assert_eq!(one.unwrap().notices[0].args["name"], "map.txt");
        let two = import(&zipped(&[("a.txt", map), ("b.txt", other)]), "x.zip").unwrap_err();
        assert!(two.contains("a.txt, b.txt"), "{two}");
        assert!(import(&zipped(&[("readme", b"hello")]), "x.zip").unwrap_err().contains("without a map"));
        let mut gz = GzEncoder::new(Vec::new(), Compression::default());
        gz.write_all(map).unwrap();
        assert_eq!(import(&gz.finish().unwrap(), "map.txt.gz").unwrap().spec.name, "map");
    }

    #[test]
    fn a_ros_pair_is_one_map() {
        let yaml = b"image: maps/lab.pgm\nresolution: 0.05\norigin: [-10.0, 317284.05, 0.5]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
        let pgm = b"P5\n2 1\n255\n\xfe\x00";
        let map = import(&zipped(&[("lab.yaml", yaml), ("lab.pgm", pgm)]), "lab.zip").unwrap();
        assert_eq!((map.kind, map.grid.to_bytes()), (Kind::RosMap, vec![0, 1]));
        let world = map.spec.world.unwrap();
        assert_eq!((world.x, world.y, world.yaw), (-10.0, 317_284.05, 0.5));
        assert!(import(&zipped(&[("lab.yaml", yaml)]), "lab.zip").unwrap_err().contains("maps/lab.pgm"));
    }

    #[test]
    fn bombs_and_broken_archives_are_refused() {
        let zeros = vec![0u8; 1 << 20];
        let bomb = zipped(&[("a", &zeros)]);
        let mut left = 1000;
        let mut archive = ZipArchive::new(Cursor::new(&bomb[..])).unwrap();
        assert!(bounded(archive.by_index(0).unwrap(), &mut left, "ZIP").is_err());
        for cut in (0..bomb.len()).step_by(7) {
            let _ = import(&bomb[..cut], "x.zip");
        }
        assert!(import(b"\x1f\x8b\x08", "x.gz").is_err());
    }
}
