//! Where the files of a comparison go, and whether they may.

use std::fs::{self, File};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

use crate::comparison::report::{FRONTS_BEGIN, HEADER, ReportLanguage, ResultFile};
use crate::digest::Digest;

use crate::cli::error::CliError;
use crate::cli::output::{self, UNFINISHED, UNFINISHED_END, failure};

/// As much of a file as tells whether this program has written it: a question's whole text may stand before what tells that.
const BEGINNING: u64 = 1 << 16;

/// A folder, and the name that all files have before their endings.
#[derive(Debug, Clone)]
pub struct Place {
    folder: PathBuf,
    name: String,
}

impl Place {
    /// Files called `name` in a folder.
    pub fn new(folder: &Path, name: String) -> Self {
        Self { folder: folder.into(), name }
    }

    /// The file with this ending, after the whole name: `study.v2` has a `study.v2.csv`.
    pub fn file(&self, ending: &str) -> PathBuf {
        self.folder.join(format!("{}.{ending}", self.name))
    }

    /// Beside it, for results that must not replace what is here.
    pub fn again(&self) -> Self {
        Self { folder: self.folder.clone(), name: format!("{}.again", self.name) }
    }

    /// How the names of this comparison's files begin that are not whole yet: short, however long its own name is.
    pub fn unfinished(&self) -> String {
        let mut digest = Digest::default();
        digest.bytes(self.name.as_bytes());
        format!("{UNFINISHED}{}-", digest.hex())
    }

    /// Makes the folder, and tells before anything is run whether every file can be written and replaces nothing that is somebody else's.
    pub fn check(&self, files: &[(&'static str, ResultFile)], inputs: &[PathBuf], replace: bool) -> Result<(), CliError> {
        fs::create_dir_all(&self.folder).map_err(|error| failure(&self.folder, error))?;
        output::check_file(&self.file("partial"), &self.unfinished())?;
        files.iter().try_for_each(|(ending, file)| self.check_file(&self.file(ending), *file, inputs, replace))
    }

    fn check_file(&self, path: &Path, file: ResultFile, inputs: &[PathBuf], replace: bool) -> Result<(), CliError> {
        output::check_file(path, &self.unfinished())?;
        let refused = |what: &str| {
            let message = format!("{} {what}: it is left as it is", path.display());
            Err(CliError::usage(message, "choose another folder with --out, or overwrite it with --replace"))
        };
        if replace || !is_file(path) {
            return Ok(());
        }
        if inputs.iter().any(|input| is_same(input, path)) {
            return refused("is one of the files that are compared");
        }
        if is_ours(path, file).map_err(|error| CliError::File { action: "read", path: path.display().to_string(), error })? {
            return Ok(());
        }
        refused("is no result that this program has written")
    }

    /// Writes a file, which is the old or the new one, whatever happens.
    pub fn write(&self, path: &Path, contents: &str) -> Result<(), CliError> {
        output::put(path, contents.as_bytes(), &self.unfinished())
    }

    /// Removes what a killed process has left of files that were not whole yet. To be called by whoever has the journal.
    pub fn sweep(&self) {
        let prefix = self.unfinished();
        let is_left = |name: &str| name.starts_with(&prefix) && name.ends_with(UNFINISHED_END);
        let found = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        for file in found.filter(|file| file.file_name().to_str().is_some_and(is_left)) {
            // What cannot be removed is in nobody's way.
            let _ = fs::remove_file(file.path());
        }
    }
}

/// Whether two names are of the same file.
pub fn is_same(one: &Path, other: &Path) -> bool {
    let whole = |path: &Path| path.canonicalize().ok();
    whole(one).is_some_and(|one| whole(other) == Some(one))
}

/// A file itself, not a link to one, which is replaced and never followed.
fn is_file(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|found| found.is_file())
}

/// Whether a file begins as this program's results of this kind do; one without a byte can be replaced as well.
fn is_ours(path: &Path, file: ResultFile) -> std::io::Result<bool> {
    let mut bytes = Vec::new();
    match File::open(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(true),
        opened => opened?.take(BEGINNING).read_to_end(&mut bytes)?,
    };
    Ok(bytes.is_empty() || begins_as(file, &String::from_utf8_lossy(&bytes)))
}

fn begins_as(file: ResultFile, text: &str) -> bool {
    match file {
        ResultFile::Csv => text.starts_with(HEADER),
        ResultFile::TestsCsv => text.starts_with("instance,test,first,second,statistic,p,"),
        ResultFile::SummaryCsv => text.starts_with("instance,entry,label,role,origin,measure,"),
        ResultFile::ClaimsCsv => text.starts_with("instance,claim,improved,baseline,measure,direction,"),
        ResultFile::MatrixCsv => text.starts_with("instance,entry,measure,objective,runs,"),
        ResultFile::FrontsCsv => text.starts_with(FRONTS_BEGIN),
        ResultFile::Json | ResultFile::Link => is_json_of(text, "formicarium/comparison@"),
        ResultFile::SummaryJson => is_json_of(text, "formicarium/summary@"),
        for_people => ReportLanguage::NAMED.iter().any(|(_, language)| for_people.is_begun_by(*language, text)),
    }
}

/// Whether an object names this format first.
fn is_json_of(text: &str, format: &str) -> bool {
    let begins: String = text.chars().filter(|c| !c.is_whitespace()).take(60).collect();
    begins.starts_with(&format!("{{\"format\":\"{format}"))
}
