//! The summary as tables for a paper: LaTeX with `booktabs`.

use super::table::{Cell, Printed, printed, sentence};
use crate::experiment::analysis::Analysis;
use crate::experiment::setting::Experiment;

/// One table a map, its caption with everything that is needed to repeat it. Needs `\usepackage{booktabs}`; letters beyond Latin and Greek
/// need XeLaTeX or LuaLaTeX.
pub fn latex(experiment: &Experiment, analysis: &Analysis, command: &str) -> String {
    let setting = super::setting_of(experiment, analysis);
    let title = &experiment.question.title;
    let mut out = format!("% Made by `{command}`.\n% Needs \\usepackage{{booktabs}}.\n");
    for table in printed(experiment, analysis) {
        let rule = table.rule.replace('`', "");
        let caption = format!("{title}. {}: {rule}. {}. Formicarium, {setting}", table.name, sentence(&table.told));
        out += &environment(&table, &caption);
    }
    out
}

fn environment(table: &Printed, caption: &str) -> String {
    let columns = format!("l{}", "r".repeat(table.head.len().saturating_sub(1)));
    let row = |cells: Vec<String>| format!("    {} \\\\\n", cells.join(" & "));
    let head = row(table.head.iter().map(|name| escape(name)).collect());
    let body: String = table.rows.iter().map(|cells| row(cells.iter().map(field).collect())).collect();
    format!(
        "\n\\begin{{table}}\n  \\centering\n  \\caption{{{}}}\n  \\label{{tab:{}}}\n  \\begin{{tabular}}{{{columns}}}\n    \\toprule\n{head}    \
         \\midrule\n{body}    \\bottomrule\n  \\end{{tabular}}\n\\end{{table}}\n",
        escape(caption),
        table.id,
    )
}

fn field(cell: &Cell) -> String {
    let text = escape(&cell.text);
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
            '°' => out += "\\textdegree{}",
            '\n' | '\r' | '\t' => out.push(' '),
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
    fn letters_with_a_meaning_are_escaped() {
        assert_eq!(
            escape("a_b & 5 % {#1} \\ ~^ $x"),
            "a\\_b \\& 5 \\% \\{\\#1\\} \\textbackslash{} \\textasciitilde{}\\textasciicircum{} \\$x"
        );
        assert_eq!(escape("η = 1/d, 20 × 20, ±0.1, 1–2, −3"), "$\\eta$ = 1/d, 20 $\\times$ 20, $\\pm$0.1, 1--2, $-$3");
        assert_eq!(escape("蚁群\nx"), "蚁群 x");
    }
}
