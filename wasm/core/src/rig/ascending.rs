//! Rows of ascending numbers: each number is written as its difference from the previous one, minus 1.

use super::{
    bytes::{Reader, Writer},
    error::RigError,
};

/// All lengths come first, then all numbers.
pub(super) fn write_rows<R: ExactSizeIterator<Item = u32>>(rows: impl Iterator<Item = R> + Clone, to: &mut Writer) {
    rows.clone().for_each(|row| to.count(row.len()));
    for row in rows {
        let mut next = 0;
        for number in row {
            to.varint(number - next);
            next = number + 1;
        }
    }
}

/// Reads a number of rows. `unknown` is the error for an invalid number.
pub(super) fn read_rows(
    from: &mut Reader<'_>,
    rows: usize,
    is_known: impl Fn(usize) -> bool,
    unknown: &'static str,
) -> Result<Vec<Vec<u32>>, RigError> {
    from.expect(from.has(Some(rows)), "end too early")?;
    let mut counts = Vec::with_capacity(rows);
    let mut entries = 0_usize;
    for _ in 0..rows {
        let count = from.varint()? as usize;
        entries = entries.saturating_add(count);
        from.expect(from.has(Some(entries)), "end too early")?;
        counts.push(count);
    }
    let mut read = Vec::with_capacity(rows);
    for count in counts {
        let mut next = 0_usize;
        let mut row = Vec::with_capacity(count);
        for _ in 0..count {
            let number = next.saturating_add(from.varint()? as usize);
            from.expect(is_known(number), unknown)?;
            row.push(number as u32);
            next = number + 1;
        }
        read.push(row);
    }
    Ok(read)
}
