//! The layout of a project as text: one line for each key of the project, for each handle, and for each key of a clip.
//!
//! A change of one handle then changes one line.

use std::io::{self, Write};

use serde_json::ser::Formatter;

/// Depth of lists whose items have their own lines: the handles, and the keys of clips.
const LISTED: usize = 2;
const LISTED_IN_CLIPS: usize = 6;

/// Breaks lines in the outermost object and in lists of handles, clips, tracks and keys. Everything else stays on one
/// line.
#[derive(Debug, Default)]
pub(super) struct Layout {
    depth: usize,
    /// Whether the current key of the outermost object is `clips`.
    in_clips: bool,
    /// Whether the innermost list or object has an item.
    filled: bool,
}

impl Layout {
    fn open<W: Write + ?Sized>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.depth += 1;
        self.filled = false;
        writer.write_all(bracket)
    }

    /// Whether each item of a list at this depth has its own line.
    fn lists_lines(&self, depth: usize) -> bool {
        depth <= if self.in_clips { LISTED_IN_CLIPS } else { LISTED }
    }

    fn break_line<W: Write + ?Sized>(&self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b"\n")?;
        (0..self.depth).try_for_each(|_| writer.write_all(b"  "))
    }
}

impl Formatter for Layout {
    /// Writes whole numbers without a decimal point, as browsers do. Messages need the standard library's number
    /// formatting anyway, and that of serde_json would add twelve kilobytes to a download.
    fn write_f64<W: Write + ?Sized>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        const LARGEST_EXACT: f64 = 9_007_199_254_740_992.0;
        if value.fract() == 0.0 && value.abs() <= LARGEST_EXACT {
            write!(writer, "{}", value as i64)
        } else {
            write!(writer, "{value:?}")
        }
    }

    fn write_string_fragment<W: Write + ?Sized>(&mut self, writer: &mut W, fragment: &str) -> io::Result<()> {
        // The strings in the outermost object are its keys, and the version of the format.
        if self.depth == 1 {
            self.in_clips = fragment == "clips";
        }
        serde_json::ser::CompactFormatter.write_string_fragment(writer, fragment)
    }

    fn begin_array<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open(writer, b"[")
    }

    fn begin_array_value<W: Write + ?Sized>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        if !first {
            writer.write_all(b",")?;
        }
        match first {
            _ if self.lists_lines(self.depth) => self.break_line(writer),
            true => Ok(()),
            false => writer.write_all(b" "),
        }
    }

    fn end_array_value<W: Write + ?Sized>(&mut self, _: &mut W) -> io::Result<()> {
        self.filled = true;
        Ok(())
    }

    fn end_array<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        self.depth -= 1;
        if self.filled && self.lists_lines(self.depth + 1) {
            self.break_line(writer)?;
        }
        writer.write_all(b"]")
    }

    fn begin_object<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open(writer, b"{")
    }

    fn begin_object_key<W: Write + ?Sized>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        if !first {
            writer.write_all(b",")?;
        }
        match self.depth {
            1 => self.break_line(writer),
            _ => writer.write_all(b" "),
        }
    }

    fn begin_object_value<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b": ")
    }

    fn end_object_value<W: Write + ?Sized>(&mut self, _: &mut W) -> io::Result<()> {
        self.filled = true;
        Ok(())
    }

    fn end_object<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        self.depth -= 1;
        match (self.filled, self.depth) {
            (false, _) => {}
            (true, 0) => self.break_line(writer)?,
            (true, _) => writer.write_all(b" ")?,
        }
        writer.write_all(b"}")
    }
}
