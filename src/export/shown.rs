//! What a figure shows beside the algorithm's state, by name.

use octoscope_figure::Show;

/// Names of all that can be shown, and where it is kept.
fn parts(show: &mut Show) -> [(&'static str, &mut bool); 8] {
    [
        ("order-numbers", &mut show.order_numbers),
        ("half-open-sides", &mut show.half_open_sides),
        ("codes", &mut show.codes),
        ("mirrored-ray", &mut show.mirrored_ray),
        ("content", &mut show.content),
        ("empty-leaves", &mut show.empty_leaves),
        ("ancestors", &mut show.ancestors),
        ("children", &mut show.children),
    ]
}

const NOTHING: Show = Show {
    order_numbers: false,
    half_open_sides: false,
    codes: false,
    mirrored_ray: false,
    content: false,
    empty_leaves: false,
    ancestors: false,
    children: false,
};

/// What these names between commas stand for; `none` for nothing.
///
/// # Errors
/// Lists the names there are.
pub fn parse_shown(text: &str) -> Result<Show, String> {
    let mut show = NOTHING;
    for name in text.split(',').map(str::trim).filter(|_| text != "none") {
        let mut parts = parts(&mut show);
        match parts.iter_mut().find(|(known, _)| *known == name) {
            Some((_, part)) => **part = true,
            None => {
                let known = parts.map(|(name, _)| name).join(", ");
                return Err(format!("there is no ‘{name}’ to show; there are {known}, and none"));
            }
        }
    }
    Ok(show)
}

/// The names, as [`parse_shown`] reads them.
pub fn print_shown(show: &Show) -> String {
    let mut show = *show;
    let names: Vec<_> =
        parts(&mut show).into_iter().filter(|(_, is_on)| **is_on).map(|(name, _)| name).collect();
    if names.is_empty() { "none".to_owned() } else { names.join(",") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_is_shown() {
        for show in [NOTHING, Show::default(), Show::at_first::<3>()] {
            assert_eq!(parse_shown(&print_shown(&show)), Ok(show));
        }
        assert_eq!(parse_shown("codes"), Ok(Show { codes: true, ..NOTHING }));
        assert!(parse_shown("codes,all").unwrap_err().contains("‘all’"));
    }
}
