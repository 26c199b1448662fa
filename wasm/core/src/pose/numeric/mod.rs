//! Sparse factorisations and roots, independent of sites, handles and pictures.
//!
//! - `laplacian`: a weighted graph with some vertices as boundary, factorised by `elimination` without subtractions.
//! - `cholesky`: a symmetric positive definite matrix of small blocks.
//! - `root`: the first root of a quadratic polynomial.

mod cholesky;
mod elimination;
mod laplacian;
mod root;

pub(super) use cholesky::{Blocks, Pattern, Slot};
pub(super) use laplacian::Laplacian;
pub(super) use root::first_root;
