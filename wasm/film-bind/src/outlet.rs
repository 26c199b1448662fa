//! An output that keeps bytes until they are taken, with their positions.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::io::{self, Seek, SeekFrom, Write};
use std::rc::Rc;

/// Bytes that have been written but not taken. Copies share them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Outlet(Rc<RefCell<Written>>);

#[derive(Debug, Default)]
struct Written {
    pieces: VecDeque<(u64, Vec<u8>)>,
    /// The position of the next byte.
    position: u64,
    length: u64,
}

impl Outlet {
    /// The oldest bytes, and their position; `None` if all have been taken.
    pub(crate) fn take(&self) -> Option<(u64, Vec<u8>)> {
        self.0.borrow_mut().pieces.pop_front()
    }
}

impl Write for Outlet {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut written = self.0.borrow_mut();
        let position = written.position;
        match written.pieces.back_mut() {
            Some((start, last)) if *start + last.len() as u64 == position => last.extend(bytes),
            _ => written.pieces.push_back((position, bytes.to_vec())),
        }
        written.position += bytes.len() as u64;
        written.length = written.length.max(written.position);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Outlet {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let mut written = self.0.borrow_mut();
        let position = match to {
            SeekFrom::Start(position) => Some(position),
            SeekFrom::Current(by) => written.position.checked_add_signed(by),
            SeekFrom::End(by) => written.length.checked_add_signed(by),
        };
        written.position = position.ok_or(io::ErrorKind::InvalidInput)?;
        Ok(written.position)
    }
}

#[cfg(test)]
mod tests {
    use std::io::{Seek, SeekFrom, Write};

    use super::Outlet;

    #[test]
    fn bytes_are_taken_once_with_their_positions() {
        let mut outlet = Outlet::default();
        outlet.write_all(b"length").unwrap();
        outlet.write_all(b" body").unwrap();
        assert_eq!(outlet.take(), Some((0, b"length body".to_vec())));
        assert_eq!(outlet.take(), None);
        outlet.write_all(b" end").unwrap();
        outlet.seek(SeekFrom::Start(0)).unwrap();
        outlet.write_all(b"LENGTH").unwrap();
        assert_eq!(outlet.seek(SeekFrom::End(0)).unwrap(), 15);
        assert_eq!([outlet.take(), outlet.take()], [Some((11, b" end".to_vec())), Some((0, b"LENGTH".to_vec()))]);
    }
}
