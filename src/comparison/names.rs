//! Names of files, as results and questions tell them: with folders of any system, or without.

/// A file's name without its folders, e.g. `arena2.map` of `maps/dao/arena2.map`.
pub fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// The same without its ending, e.g. `arena2`. A name that begins with its only dot has no ending.
pub fn stem(path: &str) -> &str {
    let file = file_name(path);
    match file.rsplit_once('.') {
        Some((stem, _)) if !stem.is_empty() => stem,
        _ => file,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stems_of_file_names() {
        assert_eq!(stem("maps/dao/arena2.map"), "arena2");
        assert_eq!(stem("C:\\maps\\a.b.csv"), "a.b");
        assert_eq!(stem(".map"), ".map");
        assert_eq!(stem(""), "");
    }
}
