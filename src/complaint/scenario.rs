//! What is wrong with a scenario, in the language of the window.

use octoscope_core::geometry::RayError;
use octoscope_core::scenario::{Fault, LEAST, SourceError, VERSION};
use octoscope_core::text::{Texts, Value};
use octoscope_core::tree::{DomainError, MAX_ROOT_LEVEL};

/// The fact, then what to do.
pub(super) fn of_fault(texts: &Texts, fault: &Fault) -> String {
    let get = |key: &str| texts.get(&format!("error-scenario-{key}"));
    let number = |key: &str, name, number: String| {
        texts.format(&format!("error-scenario-{key}"), &[(name, number.into())])
    };
    match fault {
        Fault::NoObject => number("no-object", "least", LEAST.to_owned()),
        Fault::Newer(version) => {
            texts.format("error-newer", &[("version", version.to_string().into())])
        }
        Fault::NoVersion => number("no-version", "version", VERSION.to_string()),
        Fault::Dimension(given) => number("dimension", "given", given.to_string()),
        Fault::NoDimension => get("no-dimension"),
        Fault::Kinds(count) => number("kinds", "count", count.to_string()),
        Fault::Stray { field, with } => {
            let arguments =
                [("field", (*field).to_owned().into()), ("with", (*with).to_owned().into())];
            texts.format("error-scenario-stray", &arguments)
        }
        Fault::Row(row) => number("row", "row", row.to_string()),
        Fault::NoPixels => get("no-pixels"),
        Fault::Level(given, _) => {
            let arguments =
                [("given", given.to_string().into()), ("most", MAX_ROOT_LEVEL.to_string().into())];
            texts.format("error-scenario-level", &arguments)
        }
        Fault::Capacity => get("capacity"),
        Fault::Ray(RayError::NotFinite) => get("ray-not-finite"),
        Fault::Ray(RayError::ZeroDirection) => get("ray-zero"),
        Fault::Direction(_) => get("direction"),
        Fault::Domain(DomainError::NotABox) => get("domain"),
        Fault::Domain(DomainError::TooDeep(depth)) => {
            let arguments =
                [("given", depth.to_string().into()), ("most", MAX_ROOT_LEVEL.to_string().into())];
            texts.format("error-scenario-level", &arguments)
        }
        Fault::Domain(DomainError::TooFine) => texts.get("error-too-fine"),
        Fault::Outside { count, first, .. } => super::outside(texts, *count, *first),
        Fault::Unusable { .. } => get("unusable"),
        Fault::Source(source) => of_source(texts, source),
        Fault::Field(told) => told.told(texts),
    }
}

fn of_source(texts: &Texts, source: &SourceError) -> String {
    let format = |key: &str, arguments: &[(&str, String)]| {
        let arguments: Vec<(&str, Value<'_>)> =
            arguments.iter().map(|(name, text)| (*name, text.clone().into())).collect();
        texts.format(key, &arguments)
    };
    match source {
        SourceError::Unknown { name, known } => {
            format("error-scenario-unknown", &[("name", name.clone()), ("known", known.clone())])
        }
        SourceError::Dimension { name, has, asked } => format(
            "error-scenario-other-dimension",
            &[("name", name.clone()), ("has", has.to_string()), ("asked", asked.to_string())],
        ),
        SourceError::NoParameter { name, parameter } => format(
            "error-scenario-no-parameter",
            &[("name", name.clone()), ("parameter", (*parameter).to_owned())],
        ),
        SourceError::Range { name, n, most } => format(
            "error-scenario-range",
            &[("name", name.clone()), ("n", n.to_string()), ("most", most.to_string())],
        ),
        // Of a scenario that is read the file is read as well.
        SourceError::NotRead(_) => format("error-scenario", &[("details", source.to_string())]),
    }
}
