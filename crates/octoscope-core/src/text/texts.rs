//! Texts by key.

use super::Language;
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource};

/// Argument of a text: a string or a number, by `into`.
pub type Value<'a> = fluent_bundle::FluentValue<'a>;

/// Texts of one language.
pub struct Texts {
    language: Language,
    bundle: FluentBundle<FluentResource>,
}

impl Texts {
    /// Texts from Fluent sources; a key of a later source replaces that of an
    /// earlier one. What cannot be read is left out: tests see to it that there
    /// is no such thing in compiled-in sources.
    pub fn new(language: Language, sources: &[&str]) -> Self {
        let mut bundle = FluentBundle::new_concurrent(vec![language.tag()]);
        bundle.set_use_isolating(false);
        for source in sources {
            let resource = match FluentResource::try_new((*source).to_owned()) {
                Ok(resource) | Err((resource, _)) => resource,
            };
            bundle.add_resource_overriding(resource);
        }
        Self { language, bundle }
    }

    /// The language.
    pub fn language(&self) -> Language {
        self.language
    }

    /// Whether there is a text of this key.
    pub fn has(&self, key: &str) -> bool {
        self.bundle.has_message(key)
    }

    /// Text of `key`; the key itself if there is none.
    pub fn get(&self, key: &str) -> String {
        self.format(key, &[])
    }

    /// Text of `key` with named arguments; the key itself if there is none.
    pub fn format(&self, key: &str, arguments: &[(&str, Value<'_>)]) -> String {
        let Some(pattern) = self.bundle.get_message(key).and_then(|message| message.value()) else {
            return key.to_owned();
        };
        let mut named = FluentArgs::with_capacity(arguments.len());
        for (name, value) in arguments {
            named.set(*name, value.clone());
        }
        // An argument that is missing shows as {$name}.
        let mut errors = Vec::new();
        self.bundle.format_pattern(pattern, Some(&named), &mut errors).into_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shared<T: Send + Sync>(_: &T) {}

    #[test]
    fn plurals_and_strings_are_placed_and_a_missing_key_shows_itself() {
        let source =
            "leaves = { $n -> \n  [one] { $n } leaf\n *[other] { $n } leaves\n } of { $who }\n";
        let texts = Texts::new(Language::English, &[source]);
        shared(&texts);
        assert_eq!(texts.format("leaves", &[("n", 1.into()), ("who", "A".into())]), "1 leaf of A");
        assert_eq!(
            texts.format("leaves", &[("n", 2.into()), ("who", "A".into())]),
            "2 leaves of A"
        );
        assert_eq!(texts.get("nothing"), "nothing");
    }
}
