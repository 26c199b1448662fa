//! Memory that the system refuses. By itself, the standard library would print a backtrace and abort.
//!
//! Stable Rust has no other hook for it than the allocator, so this is the only unsafe code.
#![expect(unsafe_code, reason = "an allocator cannot be written without")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::{self, Write};
use std::process;

use crate::progress;

/// The allocator of the system. Where that has no memory left, it ends the program with one line and exit status 1.
#[derive(Debug)]
pub struct Memory;

// SAFETY: every call is passed to `System` unchanged, and its result is returned unless it is null.
unsafe impl GlobalAlloc for Memory {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller keeps the promises that `System` asks for.
        given(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
        given(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as above.
        given(unsafe { System.realloc(block, layout, size) }, size)
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(block, layout) }
    }
}

fn given(block: *mut u8, bytes: usize) -> *mut u8 {
    if block.is_null() {
        refused(bytes);
    }
    block
}

/// Nothing here needs memory.
#[cold]
fn refused(bytes: usize) -> ! {
    progress::clear_if_free();
    let megabytes = bytes.div_ceil(1_000_000);
    let _ = writeln!(
        io::stderr(),
        "c2warp: not enough memory for {megabytes} MB more: use a smaller picture, a lower --scale or fewer --jobs"
    );
    process::exit(1)
}
