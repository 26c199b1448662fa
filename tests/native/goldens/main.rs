//! Golden tests of scenes after the paper's figures, and of one that a brush has moved. The goldens were inspected by
//! eye. Further tests check statements of the paper about its figures.

mod comparison;
mod figures;
mod pictures;
