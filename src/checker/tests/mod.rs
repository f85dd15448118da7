//! Tests of the checker: for each rule, steps that would prove something false without a condition, and proofs that replay.

mod attack;
mod drawn;
mod families;
mod formula;
mod modulo;
mod mutated;
mod numbers;
mod proofs;
mod records;
mod refused;
