//! Formulas: any text is read with one meaning or refused, and what is kept of it means the same.
#![no_main]

use libfuzzer_sys::fuzz_target;
use rederive::expr::Graph;
use rederive::latex::{self, Declaration, Role, Scope};

/// The symbols of the formulas: scalars of every role, a vector, a matrix, a function by its name.
fn scope(graph: &mut Graph) -> Scope {
    let mut scope = Scope::new(graph);
    for (name, role) in [
        ("t", Role::Time),
        ("x", Role::State),
        ("y", Role::State),
        (r"\theta", Role::State),
        (r"\psi", Role::State),
        ("a", Role::Parameter),
        ("k", Role::Parameter),
        ("m", Role::Parameter),
        (r"\omega", Role::Parameter),
        ("I_1", Role::Parameter),
        ("I_2", Role::Parameter),
        ("E", Role::Parameter),
    ] {
        let declaration = Declaration::of(role);
        let _ = scope.declare(graph, name, declaration);
    }
    scope
}

fuzz_target!(|text: &str| {
    let mut graph = Graph::new();
    let scope = scope(&mut graph);
    let Ok(read) = latex::read(text, &scope, &mut graph) else { return };
    // Without comments and labels it says the same.
    let printed = latex::printed(text).expect("what is read can be printed");
    let again = latex::read(&printed, &scope, &mut graph).expect("what is printed is read");
    let sides = |all: &[latex::Statement]| -> Vec<_> {
        all.iter()
            .flat_map(|s| &s.relations)
            .map(|r| (r.kind, r.left.components.clone(), r.right.components.clone()))
            .collect()
    };
    assert_eq!(sides(&read), sides(&again), "{printed}");
});
