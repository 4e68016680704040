//! Several things in as few rows as have room, filled as evenly as can be.

use eframe::egui::Ui;

/// Numbers of things of these widths in each row, with `gap` between them: as few rows as
/// there are where each is filled up to `room`, the widest of them as narrow as can be.
pub fn balanced_rows(widths: &[f32], gap: f32, room: f32) -> Vec<usize> {
    let whole = |row: &[f32]| row.iter().sum::<f32>() + gap * row.len().saturating_sub(1) as f32;
    let filled = |most: f32| {
        let (mut rows, mut begun) = (Vec::new(), 0);
        for n in 1..=widths.len() {
            if n == widths.len() || whole(&widths[begun..=n]) > most {
                rows.push(n - begun);
                begun = n;
            }
        }
        rows
    };
    let fewest = filled(room);
    let n = widths.len();
    let parts = (0..n).flat_map(|from| (from + 1..=n).map(move |to| from..to));
    let extents = parts.map(|part| whole(&widths[part])).filter(|&extent| extent <= room);
    let as_few = extents.filter(|&extent| filled(extent).len() <= fewest.len());
    let narrowest = as_few.fold(room, f32::min);
    filled(narrowest)
}

/// Shows `items` of these widths in balanced rows.
pub fn in_rows<T>(
    ui: &mut Ui,
    items: &[T],
    widths: &[f32],
    gap: f32,
    mut show: impl FnMut(&mut Ui, &T),
) {
    let lengths = balanced_rows(widths, gap, ui.available_width());
    let mut row = |ui: &mut Ui, items: &[T]| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            items.iter().for_each(|item| show(ui, item));
        });
    };
    if lengths.len() < 2 {
        row(ui, items);
        return;
    }
    ui.vertical(|ui| {
        let mut rest = items;
        for length in lengths {
            let (items, others) = rest.split_at(length);
            rest = others;
            row(ui, items);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_as_few_as_have_room_and_evenly_filled() {
        assert_eq!(balanced_rows(&[40.0; 8], 2.0, 350.0), [8]);
        assert_eq!(balanced_rows(&[48.0; 8], 2.0, 350.0), [4, 4]);
        assert_eq!(balanced_rows(&[48.0; 7], 2.0, 250.0), [4, 3]);
        assert_eq!(balanced_rows(&[100.0, 30.0, 100.0], 2.0, 140.0), [2, 1]);
        assert_eq!(balanced_rows(&[100.0; 2], 2.0, 50.0), [1, 1]);
        assert_eq!(balanced_rows(&[168.0, 46.0, 84.0], 2.0, 247.0), [1, 2]);
        assert_eq!(balanced_rows(&[], 2.0, 50.0), [0; 0]);
    }
}
