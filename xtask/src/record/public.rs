//! The questions that are asked on public maps alone. The maps are not ours to commit: experiments/public/maps.txt says how each is made of a
//! file of the data folder.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};

use super::{compare, formicarium};
use crate::tools::{root, run};

/// Where these questions stand, below experiments/.
pub const FOLDER: &str = "public/";

/// Where records on public maps stand.
pub const RECORDS: &str = "experiments/records/public";

/// Makes the maps beside the question, where it looks for them, and asks it.
pub fn record(name: &str, data: &Path) -> Result<()> {
    maps(data)?;
    run(compare(name).args(["--out", RECORDS]))
}

fn maps(data: &Path) -> Result<()> {
    let folder = root().join("experiments").join(FOLDER);
    let list = fs::read_to_string(folder.join("maps.txt")).context("cannot read the list of public maps")?;
    let maps = folder.join("maps");
    fs::create_dir_all(&maps).with_context(|| format!("cannot make {}", maps.display()))?;
    for line in list.lines().filter(|line| !line.starts_with('#')) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [name, file, arguments @ ..] = &words[..] else { bail!("{line}: NAME FILE ARGUMENTS is expected") };
        let mut convert = formicarium();
        convert.arg("convert").arg(data.join(file)).arg(maps.join(name).with_extension("json")).args(arguments);
        run(&mut convert)?;
    }
    Ok(())
}
