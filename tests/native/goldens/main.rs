//! The paper's figures as scenes: their warped pictures as they once were looked at and found good, and what the paper says
//! of them.

mod comparison;
mod figures;
mod pictures;
