//! Text as LaTeX reads it.

use super::{RichText, Span};

/// `text` for LaTeX with any of its engines: signs of its own are escaped,
/// signs that typefaces lack are set in mathematics, subscripts are formulas. If
/// `axes` names colours, it is set as in figures: letters of axes bold in these
/// colours, subscripts in the typeface of the text.
pub fn latex(text: &RichText, axes: Option<[&str; 3]>) -> String {
    let mut out = String::new();
    let mut spans = text.0.iter().peekable();
    while let Some(span) = spans.next() {
        let sub = if span.sub { None } else { spans.next_if(|next| next.sub) };
        let mut set = String::new();
        // The letter before a subscript belongs to the formula.
        let letter = span.text.chars().next_back().filter(|_| sub.is_some());
        let plain = &span.text[..span.text.len() - letter.map_or(0, char::len_utf8)];
        if axes.is_some() {
            set += &if span.sub { subscript(&span.text) } else { escaped(&span.text) };
            set += &sub.map_or(String::new(), |sub| subscript(&sub.text));
            out += &in_look(span, set, axes);
            continue;
        }
        if span.sub {
            set += &format!("$_{{{}}}$", escaped(plain));
        } else {
            set += &escaped(plain);
        }
        if let Some(sub) = sub {
            let letter = letter.map_or(String::new(), String::from);
            set += &format!("${letter}_{{{}}}$", escaped(&sub.text));
        }
        out += &in_look(span, set, axes);
    }
    out
}

fn subscript(text: &str) -> String {
    format!("\\textsubscript{{{}}}", escaped(text))
}

fn in_look(span: &Span, mut set: String, axes: Option<[&str; 3]>) -> String {
    let colour = span.axis.and_then(|axis| axes?.get(axis).copied());
    if span.strong || colour.is_some() {
        set = format!("\\textbf{{{set}}}");
    }
    match colour {
        Some(colour) => format!("\\textcolor{{{colour}}}{{{set}}}"),
        None => set,
    }
}

fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '\\' => out += "\\textbackslash{}",
            '~' => out += "\\textasciitilde{}",
            '^' => out += "\\textasciicircum{}",
            '{' | '}' | '$' | '&' | '#' | '_' | '%' => out.extend(['\\', c]),
            // As text these depend on the encoding of the typeface.
            '<' | '>' | '|' | '*' => out.extend(['$', c, '$']),
            '−' => out += "$-$",
            '"' => out += "\\textquotedbl{}",
            '\u{a0}' => out.push('~'),
            '\u{2009}' | '\u{202f}' => out += "\\,",
            '…' => out += "\\dots{}",
            '°' => out += "$^\\circ$",
            '₀'..='₉' => {
                out += &format!("\\textsubscript{{{}}}", u32::from(c) - u32::from('₀'))
            }
            'ₘ' => out += "\\textsubscript{m}",
            c if c.is_control() => out.push(' '),
            c if (c as u32) < 0x180 || ('–'..='„').contains(&c) => out.push(c),
            c => match mathematics(c) {
                Some(name) => out += &format!("$\\{name}$"),
                None => out += &format!("[U+{:04X}]", u32::from(c)),
            },
        }
    }
    out
}

/// Command of a mathematical sign, without the backslash.
fn mathematics(c: char) -> Option<&'static str> {
    Some(match c {
        '∞' => "infty",
        '≤' => "le",
        '≥' => "ge",
        '≠' => "ne",
        '≈' => "approx",
        '∧' => "wedge",
        '∨' => "vee",
        '⊕' => "oplus",
        '¬' => "neg",
        '∈' => "in",
        '→' => "rightarrow",
        '←' => "leftarrow",
        '↑' => "uparrow",
        '↓' => "downarrow",
        '↔' => "leftrightarrow",
        '⇒' => "Rightarrow",
        '√' => "surd",
        '∅' => "emptyset",
        '∩' => "cap",
        '∪' => "cup",
        'Σ' => "Sigma",
        'Δ' => "Delta",
        'α' => "alpha",
        'β' => "beta",
        'ε' => "varepsilon",
        'π' => "pi",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(text: &str) -> Span {
        Span { text: text.to_owned(), ..Span::default() }
    }

    #[test]
    fn text_is_safe_for_latex() {
        let check = |text, expected| {
            assert_eq!(latex(&RichText(vec![plain(text)]), None), expected, "{text}");
        };
        check("Würfel über Größe", "Würfel über Größe");
        check("50 % of #1 & {x}_y", "50 \\% of \\#1 \\& \\{x\\}\\_y");
        check("\\a~b^c", "\\textbackslash{}a\\textasciitilde{}b\\textasciicircum{}c");
        check("−∞ … 3°", "$-$$\\infty$ \\dots{} 3$^\\circ$");
        check("a < b", "a $<$ b");
        check("x₀", "x\\textsubscript{0}");
        check("tₘ", "t\\textsubscript{m}");
        check("„so“ – ‘x’", "„so“ – ‘x’");
        check("a\u{1}b ☃", "a b [U+2603]");
    }

    #[test]
    fn subscripts_and_axes_are_kept() {
        let on_x = |text: &str, sub| Span { axis: Some(0), sub, ..plain(text) };
        let strong = Span { strong: true, ..plain("1") };
        let text = RichText(vec![on_x("t", false), on_x("x0", true), plain(" = "), strong]);
        assert_eq!(latex(&text, None), "$t_{x0}$ = \\textbf{1}");
        let axes = ["ax", "ay", "az"];
        let as_in_figures = "\\textcolor{ax}{\\textbf{t\\textsubscript{x0}}} = \\textbf{1}";
        assert_eq!(latex(&text, Some(axes)), as_in_figures);
        let low = RichText(vec![on_x("x", false), plain(" − "), on_x("1", true)]);
        let as_in_figures = "\\textcolor{ax}{\\textbf{x}} $-$ ";
        assert!(latex(&low, Some(axes)).starts_with(as_in_figures));
    }
}
