//! A formula as LaTeX sets it.

use super::term::{Fence, Formula};

/// `formula` for the inside of `$…$`; what belongs to an axis is in the colour
/// that `axes` names, if it does.
pub fn math(formula: &Formula, axes: Option<[&str; 3]>) -> String {
    let set = |part: &Formula| math(part, axes);
    match formula {
        Formula::Row(parts) => parts.iter().map(set).collect::<Vec<_>>().join(" "),
        Formula::Symbol { name, axis } => {
            let name = symbol(name);
            match axis.and_then(|axis| axes?.get(axis).copied()) {
                Some(colour) => format!("\\textcolor{{{colour}}}{{{name}}}"),
                None => name,
            }
        }
        Formula::Number { shown, .. } => digits(shown),
        Formula::Digits(text) => digits(text),
        Formula::Words(text) => match text.as_str() {
            "max" | "min" => format!("\\{text}"),
            text => format!("\\textrm{{{}}}", escaped(text)),
        },
        Formula::Sign(sign) => sign.latex().to_owned(),
        Formula::Sub { body, below } => format!("{{{}}}_{{{}}}", set(body), set(below)),
        Formula::Sup { body, above } => format!("{{{}}}^{{{}}}", set(body), set(above)),
        Formula::Fraction { over, under } => format!("\\frac{{{}}}{{{}}}", set(over), set(under)),
        Formula::Over { operator, limit } => format!("\\{operator}\\limits_{{{}}}", set(limit)),
        Formula::Fenced { fence, body } => {
            let [open, close] = match fence {
                Fence::Round => ["(", ")"],
                Fence::Floor => ["\\lfloor", "\\rfloor"],
                Fence::Ceiling => ["\\lceil", "\\rceil"],
                Fence::Absolute => ["|", "|"],
            };
            if is_low(body) {
                return format!("{open}{}{close}", padded(&set(body), *fence));
            }
            format!("\\left{open} {} \\right{close}", set(body))
        }
    }
}

/// Whether brackets of the usual height go round it.
fn is_low(formula: &Formula) -> bool {
    match formula {
        Formula::Row(parts) => parts.iter().all(is_low),
        Formula::Sub { body, .. } | Formula::Sup { body, .. } | Formula::Fenced { body, .. } => {
            is_low(body)
        }
        Formula::Fraction { .. } | Formula::Over { .. } => false,
        Formula::Symbol { .. }
        | Formula::Number { .. }
        | Formula::Digits(_)
        | Formula::Words(_)
        | Formula::Sign(_) => true,
    }
}

/// What is between brackets, apart from those that end in letters.
fn padded(body: &str, fence: Fence) -> String {
    match fence {
        Fence::Floor | Fence::Ceiling => format!(" {body} "),
        Fence::Round | Fence::Absolute => body.to_owned(),
    }
}

/// A name: one letter as a letter of mathematics, a word upright.
fn symbol(name: &str) -> String {
    let set = match name {
        "′" => "\\prime".to_owned(),
        "Δ" => "\\Delta".to_owned(),
        "ℓ" => "\\ell".to_owned(),
        "max" | "min" => format!("\\{name}"),
        name => escaped(name),
    };
    if set.chars().count() > 2 && !set.starts_with('\\') {
        return format!("\\mathrm{{{set}}}");
    }
    set
}

fn digits(text: &str) -> String {
    match text {
        "NaN" => "\\mathrm{NaN}".to_owned(),
        text => text.replace('−', "-").replace('∞', "\\infty ").trim_end().to_owned(),
    }
}

fn escaped(text: &str) -> String {
    let span = crate::explain::Span { text: text.to_owned(), ..crate::explain::Span::default() };
    crate::explain::latex(&crate::explain::RichText(vec![span]), None)
}

#[cfg(test)]
mod tests {
    use super::super::term::{Sign, row};
    use super::*;

    #[test]
    fn formulas_are_mathematics_for_latex() {
        let check = |formula: Formula, expected: &str| assert_eq!(math(&formula, None), expected);
        let quotient = row![Formula::coordinate(0, "m"), Sign::Minus, Formula::on(0, "p", "")];
        let quotient = quotient.over(Formula::on(0, "d", ""));
        check(quotient.clone(), "\\frac{{x}_{m} - {p}_{x}}{{d}_{x}}");
        check(
            quotient.fenced(Fence::Floor),
            "\\left\\lfloor \\frac{{x}_{m} - {p}_{x}}{{d}_{x}} \\right\\rfloor",
        );
        check(row!["a", Sign::Xor, "b"].fenced(Fence::Round), "(a \\oplus b)");
        check(row!["a"].fenced(Fence::Ceiling), "\\lceil a \\rceil");
        check(Formula::call("max", ["a".into(), 0.into()]), "\\max (a ,\\; 0)");
        check(Formula::Digits("−∞".to_owned()), "-\\infty");
        check(Formula::Words("kein Treffer".to_owned()), "\\textrm{kein Treffer}");
        check("loc".into(), "\\mathrm{loc}");
        check("ℓ".into(), "\\ell");
        let coloured = math(&Formula::on(1, "t", "m"), Some(["ax", "ay", "az"]));
        assert_eq!(coloured, "{\\textcolor{ay}{t}}_{\\textcolor{ay}{ym}}");
    }
}
