//! Sparse factorisations and descent: numerics that are independent of sites, handles and pictures.
//!
//! - `laplacian`: a weighted graph with some vertices as boundary, factorised by `elimination` without subtractions.
//! - `cholesky`: any symmetric positive definite matrix.
//! - `descent`: minimises an energy, with one of these as approximate inverse of its Hessian.
//! - `jet`: a number along a line, with its derivatives.

mod cholesky;
mod descent;
mod elimination;
mod jet;
mod laplacian;

pub(super) use cholesky::Cholesky;
pub(super) use descent::{Limits, Objective, descend};
pub(super) use jet::Jet;
pub(super) use laplacian::Laplacian;
