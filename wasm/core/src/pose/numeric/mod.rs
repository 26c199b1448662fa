//! Sparse factorisations, independent of sites, handles and pictures.
//!
//! - `laplacian`: a weighted graph with some vertices as boundary, factorised by `elimination` without subtractions.
//! - `cholesky`: a symmetric positive definite matrix of small blocks.

mod cholesky;
mod elimination;
mod laplacian;

pub(super) use cholesky::{Blocks, Pattern, Slot};
pub(super) use laplacian::Laplacian;
