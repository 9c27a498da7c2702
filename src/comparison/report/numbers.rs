//! Numbers as reports print them.

use super::words::Words;
use crate::comparison::statistics::Summary;

/// A length or cost.
pub(super) fn length(v: f64) -> String {
    format!("{v:.3}")
}

/// Up to two decimals.
pub(super) fn short(v: f64) -> String {
    let text = format!("{v:.2}");
    text.trim_end_matches('0').trim_end_matches('.').into()
}

/// A median with its quartiles.
pub(super) fn middle(s: &Summary) -> String {
    format!("{} ({}–{})", short(s.median), short(s.lower), short(s.upper))
}

/// A median of runs; infinite: half of them or more found no path.
pub(super) fn median(words: &Words, of: Option<f64>) -> String {
    of.filter(|v| v.is_finite()).map_or_else(|| words.names.no_path.into(), length)
}

/// A share of runs.
pub(super) fn percent(words: &Words, share: f64) -> String {
    (words.signs.percent)(&format!("{:.1}", 100.0 * share))
}

/// A share in whole hundredths.
pub(super) fn hundredths(words: &Words, share: f64) -> String {
    (words.signs.percent)(&format!("{:.0}", 100.0 * share))
}

/// A gap, wherever one is printed. Only what is the reference is printed as nothing: a gap that would be rounded to it is said to be smaller than
/// the last digit, as on the page (`www/src/model/gap.ts`).
pub(super) fn gap(words: &Words, gap: f64) -> String {
    let percent = |digits: &str| (words.signs.percent)(digits);
    match format!("{:.1}", 100.0 * gap) {
        digits if gap == 0.0 || !["0.0", "-0.0"].contains(&&*digits) => percent(&digits),
        _ if gap > 0.0 => format!("< {}", percent("0.1")),
        _ => format!("> {}", percent("-0.1")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::comparison::report::ReportLanguage;

    #[test]
    fn numbers_look_as_they_should() {
        assert_eq!([17.5, 20.0, 15.75, 0.0].map(short), ["17.5", "20", "15.75", "0"]);
    }

    #[test]
    fn only_the_reference_has_no_gap() {
        let gaps = [0.0, 1e-9, 0.000_499, 0.000_501, 0.0123, -0.000_3, -0.056];
        let said = |language: ReportLanguage| gaps.map(|v| gap(language.words(), v));
        assert_eq!(said(ReportLanguage::En), ["0.0 %", "< 0.1 %", "< 0.1 %", "0.1 %", "1.2 %", "> -0.1 %", "-5.6 %"]);
        assert_eq!(said(ReportLanguage::ZhCn), ["0.0%", "< 0.1%", "< 0.1%", "0.1%", "1.2%", "> -0.1%", "-5.6%"]);
    }
}
