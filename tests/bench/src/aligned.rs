//! Markdown tables with aligned columns.

use std::fmt::Write;

/// Formats a table. The first `words` columns are aligned left. The others hold numbers and are aligned right.
#[must_use]
pub fn aligned(header: &[&str], rows: impl Iterator<Item = Vec<String>>, words: usize) -> String {
    let lines: Vec<Vec<String>> =
        std::iter::once(header.iter().map(|&cell| cell.to_owned()).collect()).chain(rows).collect();
    let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0).max(2);
    let widths: Vec<usize> = (0..header.len()).map(width).collect();
    let mut text = String::new();
    for (at, line) in lines.iter().enumerate() {
        let cell = |(column, cell): (usize, &String)| {
            let width = widths[column];
            if column < words { format!("{cell:width$}") } else { format!("{cell:>width$}") }
        };
        let cells: Vec<String> = line.iter().enumerate().map(cell).collect();
        writeln!(text, "| {} |", cells.join(" | ")).expect("writing to a string never fails");
        if at == 0 {
            let rule = |(column, &width): (usize, &usize)| match column < words {
                true => "-".repeat(width),
                false => "-".repeat(width - 1) + ":",
            };
            let rules: Vec<String> = widths.iter().enumerate().map(rule).collect();
            writeln!(text, "| {} |", rules.join(" | ")).expect("writing to a string never fails");
        }
    }
    text
}
