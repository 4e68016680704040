//! A text that is told later, in whatever language.

use super::{Texts, Value};

/// A text of the language files by its key, with what it is filled in with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// Key of the text.
    pub key: &'static str,
    arguments: Vec<(&'static str, Argument)>,
}

/// What a text is filled in with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Argument {
    /// Something that is the same in every language.
    Text(String),
    /// A number of things, by which plurals are chosen.
    Count(usize),
    /// Another message.
    Message(Message),
}

impl Message {
    /// The text of `key`, with nothing filled in yet.
    pub fn new(key: &'static str) -> Self {
        Self { key, arguments: Vec::new() }
    }

    /// The same with `argument` where the text says `name`.
    pub fn with(mut self, name: &'static str, argument: impl Into<Argument>) -> Self {
        self.arguments.push((name, argument.into()));
        self
    }

    /// The message in the language of `texts`.
    pub fn told(&self, texts: &Texts) -> String {
        let told = |argument: &Argument| -> Value<'_> {
            match argument {
                Argument::Text(text) => text.clone().into(),
                Argument::Count(n) => (*n).into(),
                Argument::Message(message) => message.told(texts).into(),
            }
        };
        let arguments: Vec<_> =
            self.arguments.iter().map(|(name, argument)| (*name, told(argument))).collect();
        texts.format(self.key, &arguments)
    }
}

impl From<String> for Argument {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<&str> for Argument {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<usize> for Argument {
    fn from(n: usize) -> Self {
        Self::Count(n)
    }
}

impl From<Message> for Argument {
    fn from(message: Message) -> Self {
        Self::Message(message)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Language;

    #[test]
    fn a_message_is_filled_in_in_the_language_that_is_told() {
        let english = "what = { $a }, { $b }\nrows = { $n ->\n    [one] row\n   *[other] rows\n}";
        let german =
            "what = { $b }, { $a }\nrows = { $n ->\n    [one] Zeile\n   *[other] Zeilen\n}";
        let message =
            Message::new("what").with("a", "x").with("b", Message::new("rows").with("n", 2));
        for (language, source, told) in
            [(Language::English, english, "x, rows"), (Language::German, german, "Zeilen, x")]
        {
            assert_eq!(message.told(&Texts::new(language, &[source])), told);
        }
    }
}
