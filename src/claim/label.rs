//! The name of a component of a comparison.
//!
//! **In:** the text of a formula, and which of its components is meant. **Out:** a text that a reader recognises, of bounded length.

use crate::expr::{Part as ComplexPart, Shape};

/// The longest formula that names each of its comparisons in full: a chain of relations has as many of them as signs.
const LONGEST_LABEL: usize = 4_000;

/// Name of a component: the formula, and the values of its free indices.
pub(crate) fn label(text: &str, indices: &[String], shape: &Shape, component: usize) -> String {
    let end = (0..=80).rev().find(|&n| text.is_char_boundary(n)).unwrap_or(0);
    let short = format!("{} …", &text[..end.min(text.len())]);
    let text = if text.len() > LONGEST_LABEL { short.as_str() } else { text };
    if shape.rank() == 0 {
        return text.to_owned();
    }
    let values = shape.real_indices(component);
    let mut named: Vec<String> = values
        .iter()
        .enumerate()
        .map(|(axis, value)| match indices.get(axis) {
            Some(name) => format!("{name} = {value}"),
            None => value.to_string(),
        })
        .collect();
    named.extend(shape.part(component).map(|part| match part {
        ComplexPart::Real => "Re".to_owned(),
        ComplexPart::Imaginary => "Im".to_owned(),
    }));
    format!("{text}   [{}]", named.join(", "))
}
