//! Texts of the window.

use octoscope_core::scenario::scenario_texts;
use octoscope_core::text::{Language, Texts};
use octoscope_figure::views::figure_texts;
use octoscope_import::import_texts;

/// Texts of the window in `language`.
pub fn texts(language: Language) -> Texts {
    let sources = match language {
        Language::English => [
            include_str!("../assets/texts/en/window.ftl"),
            figure_texts(language),
            include_str!("../assets/texts/en/gallery.ftl"),
            include_str!("../assets/texts/en/algorithms.ftl"),
            include_str!("../assets/texts/en/errors.ftl"),
            import_texts(language),
            scenario_texts(language),
        ],
        Language::German => [
            include_str!("../assets/texts/de/window.ftl"),
            figure_texts(language),
            include_str!("../assets/texts/de/gallery.ftl"),
            include_str!("../assets/texts/de/algorithms.ftl"),
            include_str!("../assets/texts/de/errors.ftl"),
            import_texts(language),
            scenario_texts(language),
        ],
    };
    Texts::new(language, &sources)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::{COMMANDS, Menu};
    use octoscope_core::paper::erratum_of;
    use octoscope_core::scenario::BUILT_IN;
    use octoscope_core::traverse::Variant;
    use octoscope_figure::views::FigureView;

    fn keys(source: &str) -> Vec<&str> {
        let named = source.lines().filter(|line| !line.starts_with(['#', ' ', '}', '\t']));
        named.filter_map(|line| line.split_once(" =")).map(|(key, _)| key).collect()
    }

    #[test]
    fn both_languages_have_the_same_keys() {
        let of = |language, own: [&'static str; 3]| {
            let others = [figure_texts, import_texts, scenario_texts].map(|texts| texts(language));
            own.into_iter().chain(others).flat_map(keys).collect::<Vec<_>>()
        };
        let english = of(
            Language::English,
            [
                include_str!("../assets/texts/en/window.ftl"),
                include_str!("../assets/texts/en/algorithms.ftl"),
                include_str!("../assets/texts/en/errors.ftl"),
            ],
        );
        let german = of(
            Language::German,
            [
                include_str!("../assets/texts/de/window.ftl"),
                include_str!("../assets/texts/de/algorithms.ftl"),
                include_str!("../assets/texts/de/errors.ftl"),
            ],
        );
        assert_eq!(english, german);
        assert!(english.len() > 100);
        for language in Language::ALL {
            let texts = texts(language);
            assert!(english.iter().all(|key| texts.has(key)), "{language:?}");
        }
    }

    #[test]
    fn commands_menus_and_scenes_have_names() {
        for language in Language::ALL {
            let texts = texts(language);
            let commands = COMMANDS.iter().map(|row| row.id.to_owned());
            let inner = Menu::ALL.into_iter().flat_map(Menu::inner).copied();
            let menus = Menu::ALL.into_iter().chain(inner).map(|menu| menu.id().to_owned());
            let scenes = BUILT_IN.iter().map(|scene| format!("scene-{}", scene.id));
            let choices = Variant::ALL.into_iter().filter(|&variant| erratum_of(variant).is_none());
            let variants = choices.flat_map(|variant| {
                ["", "-why"].map(|end| format!("variant-{}{end}", variant.id()))
            });
            let views = FigureView::ALL.map(|view| format!("figure-{}", view.id()));
            for key in commands.chain(menus).chain(views).chain(scenes).chain(variants) {
                assert!(texts.has(&key), "{key} in {language:?}");
            }
        }
    }

    #[test]
    fn every_key_that_the_sources_name_exists() {
        let texts = texts(Language::English);
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        let mut named = 0;
        let crates = ["figure/src", "import/src", "core/src/scenario"];
        let mut folders = vec![root.join("src")];
        folders.extend(crates.map(|of| root.join(format!("crates/octoscope-{of}"))));
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|ending| ending == "rs") {
                    let source = std::fs::read_to_string(&path).unwrap();
                    for start in
                        ["look.text(\"", "texts.format(\"", "texts.get(\"", "Message::new(\""]
                    {
                        for rest in source.split(start).skip(1) {
                            let key = rest.split('"').next().unwrap();
                            assert!(texts.has(key), "{key} in {}", path.display());
                            named += 1;
                        }
                    }
                }
            }
        }
        assert!(named > 40, "{named}");
    }
}
