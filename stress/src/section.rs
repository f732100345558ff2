//! Sections of documents that programs write, between `<!-- begin NAME -->` and `<!-- end NAME -->`.

use std::fs;
use std::io;
use std::path::Path;

/// Replaces a section of the document at `path`.
///
/// # Errors
/// If the document can't be read or written, or lacks the marks.
pub fn renew(path: &Path, name: &str, text: &str) -> io::Result<()> {
    let renewed = with_section(&fs::read_to_string(path)?, name, text);
    let lacking = || io::Error::other(format!("{} has no section `{name}`", path.display()));
    fs::write(path, renewed.ok_or_else(lacking)?)
}

/// `None` without the marks.
fn with_section(document: &str, name: &str, text: &str) -> Option<String> {
    let (begin, end) = (format!("<!-- begin {name} -->\n"), format!("<!-- end {name} -->\n"));
    let (before, rest) = document.split_once(&begin)?;
    let (_, after) = rest.split_once(&end)?;
    Some(format!("{before}{begin}{}\n{end}{after}", text.trim_end()))
}

#[cfg(test)]
mod tests {
    use super::with_section;

    #[test]
    fn a_section_is_replaced_between_its_marks() {
        let document = |text| format!("a\n<!-- begin x -->\n{text}\n<!-- end x -->\nb\n");
        assert_eq!(with_section(&document("old"), "x", "new\n"), Some(document("new")));
        assert_eq!(with_section(&document("old"), "y", "new"), None);
    }
}
