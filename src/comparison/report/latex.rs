//! The summary as tables for a paper: LaTeX with `booktabs` and `graphicx`.

use super::claims;
use super::printed::{Cell, printed, sentence};
use super::readings;
use super::words::Words;
use crate::comparison::Comparison;
use crate::comparison::analysis::Analysis;

/// One table a map, its caption with everything that is needed to repeat it. A table that is wider than the text is shrunk to fit it.
/// Letters beyond Latin and Greek need XeLaTeX or LuaLaTeX.
pub(super) fn latex(words: &Words, comparison: &Comparison, analysis: &Analysis, command: &str) -> String {
    let setting = super::setting_of(words, comparison, analysis);
    let mut out = head(words, command);
    for table in printed(words, comparison, analysis) {
        let rule = (words.signs.about)(&table.name, &table.rule.replace('`', ""));
        let caption = caption(words, vec![comparison.question.title.clone(), rule, sentence(&table.told)], &setting);
        out += &environment(&Table { id: &table.id, head: &table.head, rows: &table.rows, last_apart: false }, &caption);
    }
    if let Some((head, rows)) = readings::printed(words, comparison, analysis) {
        let caption = caption(words, vec![comparison.question.title.clone(), sentence(words.claims.readings_about)], &setting);
        out += &environment(&Table { id: "claims:readings", head: &head, rows: &rows, last_apart: false }, &caption);
    }
    if let Some(rows) = claims::printed(words, comparison, analysis) {
        let caption = caption(words, vec![comparison.question.title.clone(), sentence(words.claims.about)], &setting);
        let head: Vec<String> = claims::printed_head(words);
        out += &environment(&Table { id: "claims:over-maps", head: &head, rows: &rows, last_apart: false }, &caption);
    }
    out
}

/// How every such file begins.
pub(super) fn head(words: &Words, command: &str) -> String {
    format!("{}`{}`{}", words.latex.made_by, super::escape::prose(command), words.latex.needs)
}

/// What is said, sentence by sentence, and who made it.
pub(super) fn caption(words: &Words, mut said: Vec<String>, setting: &str) -> String {
    said.push((words.latex.made_with)(setting));
    said.join(words.signs.next)
}

/// What a table has.
pub(super) struct Table<'a> {
    /// The end of its label.
    pub id: &'a str,
    /// The columns.
    pub head: &'a [String],
    /// The fields.
    pub rows: &'a [Vec<Cell>],
    /// Whether a line stands before the last row.
    pub last_apart: bool,
}

/// As wide as what follows, or as the text where that is less.
const FIT: &str = "\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}";

/// A floating table with its caption.
pub(super) fn environment(table: &Table, caption: &str) -> String {
    let columns = format!("l{}", "r".repeat(table.head.len().saturating_sub(1)));
    let row = |cells: Vec<String>| format!("    {} \\\\\n", cells.join(" & "));
    let head = row(table.head.iter().map(|name| in_two_lines(&escape(name))).collect());
    let mut rows: Vec<String> = table.rows.iter().map(|cells| row(cells.iter().map(field).collect())).collect();
    if let Some(last) = rows.last_mut().filter(|_| table.last_apart) {
        last.insert_str(0, "    \\midrule\n");
    }
    let body = rows.concat();
    format!(
        "\n\\begin{{table}}\n  \\centering\n  \\caption{{{}}}\n  \\label{{tab:{}}}\n  \\small\\setlength{{\\tabcolsep}}{{4pt}}%\n  {FIT}{{%\n  \
         \\begin{{tabular}}{{{columns}}}\n    \\toprule\n{head}    \\midrule\n{body}    \\bottomrule\n  \\end{{tabular}}}}\n\\end{{table}}\n",
        escape(caption),
        table.id,
    )
}

/// Broken at the space nearest to its middle: names of columns are longer than what stands in them.
fn in_two_lines(name: &str) -> String {
    let off_centre = |at: &usize| at.abs_diff(name.len() / 2);
    match name.match_indices(' ').map(|(at, _)| at).min_by_key(off_centre) {
        Some(at) => format!("\\shortstack[r]{{{}\\\\{}}}", &name[..at], &name[at + 1..]),
        None => name.to_owned(),
    }
}

fn field(cell: &Cell) -> String {
    let text = escape(&cell.text);
    // Behind the `\\` of the row before, these would be its arguments.
    let text = if text.starts_with(['[', '*']) { format!("{{}}{text}") } else { text };
    if cell.best { format!("\\textbf{{{text}}}") } else { text }
}

/// Letters that mean something to LaTeX, and those that its fonts do not have in text.
fn escape(text: &str) -> String {
    const MATHS: [(char, &str); 35] = [
        ('−', "-"),
        ('×', "\\times"),
        ('±', "\\pm"),
        ('≤', "\\leq"),
        ('≥', "\\geq"),
        ('∞', "\\infty"),
        ('→', "\\to"),
        ('√', "\\surd"),
        ('Δ', "\\Delta"),
        ('α', "\\alpha"),
        ('β', "\\beta"),
        ('γ', "\\gamma"),
        ('δ', "\\delta"),
        ('ε', "\\varepsilon"),
        ('η', "\\eta"),
        ('θ', "\\theta"),
        ('κ', "\\kappa"),
        ('λ', "\\lambda"),
        ('μ', "\\mu"),
        ('ξ', "\\xi"),
        ('π', "\\pi"),
        ('ρ', "\\rho"),
        ('σ', "\\sigma"),
        ('τ', "\\tau"),
        ('φ', "\\varphi"),
        ('χ', "\\chi"),
        ('ψ', "\\psi"),
        ('ω', "\\omega"),
        ('Σ', "\\Sigma"),
        ('Ω', "\\Omega"),
        ('²', "^2"),
        ('³', "^3"),
        ('<', "<"),
        ('>', ">"),
        ('|', "|"),
    ];
    let mut out = String::new();
    for letter in text.chars() {
        match letter {
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => out.extend(['\\', letter]),
            '\\' => out += "\\textbackslash{}",
            '~' => out += "\\textasciitilde{}",
            '^' => out += "\\textasciicircum{}",
            '–' => out += "--",
            '†' => out += "\\textdagger{}",
            '°' => out += "\\textdegree{}",
            _ if letter.is_control() => out.push(' '),
            _ => match MATHS.iter().find(|(known, _)| *known == letter) {
                Some((_, maths)) => out += &format!("${maths}$"),
                None => out.push(letter),
            },
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_columns_are_broken_in_the_middle() {
        assert_eq!(in_two_lines("best"), "best");
        assert_eq!(in_two_lines("runs with a path"), "\\shortstack[r]{runs with\\\\a path}");
    }

    #[test]
    fn letters_with_a_meaning_are_escaped() {
        assert_eq!(
            escape("a_b & 5 % {#1} \\ ~^ $x"),
            "a\\_b \\& 5 \\% \\{\\#1\\} \\textbackslash{} \\textasciitilde{}\\textasciicircum{} \\$x"
        );
        assert_eq!(escape("η = 1/d, 20 × 20, ±0.1, 1–2, −3"), "$\\eta$ = 1/d, 20 $\\times$ 20, $\\pm$0.1, 1--2, $-$3");
        assert_eq!(escape("蚁群\nx"), "蚁群 x");
        assert_eq!(escape("< 0.1 %"), "$<$ 0.1 \\%");
        let cell = |text: &str| field(&Cell { text: text.into(), value: None, best: false });
        assert_eq!([cell("[1mm] x"), cell("*x"), cell("x *")], ["{}[1mm] x", "{}*x", "x *"]);
    }
}
