//! ± with one sign for a whole motion: what refutes it is one motion, on which neither sign serves.
//!
//! Points at which the signs fail may belong to different motions, each of which has its sign.

use crate::prove_traps::all;

#[test]
fn points_of_different_motions_refute_nothing() {
    all(&[
        ("unrefuted throughout", r"z=\pm 1", "z: state", "z^2=1"),
        ("unrefuted throughout", r"z=\pm t", "z: state", "z^2=t^2"),
        ("unrefuted throughout", r"\dot z=\pm a", "z: state; a", r"\dot z^2=a^2"),
        ("unrefuted throughout", r"|z|=\pm z", "z: state", r"\dot z=0"),
        ("unrefuted throughout", r"z=\pm w", "z, w: state", r"z^2=w^2; w>0"),
        ("unrefuted throughout", r"|at^2|=\pm at^2", "a; z: state", ""),
        ("unrefuted throughout", r"z=\pm z(0)", "z: state", "z^2=z(0)^2"),
        ("unrefuted throughout", r"u=\pm 1", "x: coordinate; u(x): field", "u^2=1"),
        ("unrefuted throughout", r"E=\pm m", "z: state; m; E: observable = \\dot z", r"\dot z^2=m^2"),
    ]);
}

#[test]
fn one_motion_refutes_both_signs() {
    all(&[
        // At one time neither serves.
        ("refuted throughout", r"z=\pm 2", "z: state", "z^2=1"),
        ("refuted throughout", r"z=\pm 1", "z: state", ""),
        ("refuted throughout", r"u=\pm 2", "x: coordinate; u(x): field", "u^2=1"),
        // Each fails at some time of z = t.
        ("refuted throughout", r"|z|=\pm z", "z: state", ""),
        ("refuted throughout", r"|z|=\pm z", "z: state", r"\dot z=1"),
        ("refuted throughout", r"|at|=\pm at", "a; z: state", ""),
        ("refuted throughout", r"|t|=\pm t", "z: state", ""),
        // What does not move has values for points.
        ("refuted throughout", r"\sqrt{x^2}=\pm x", "x", ""),
        ("proved throughout", r"|z|=\pm z", "z: state", "z>0"),
        ("proved throughout", r"|z|=\mp z", "z: state", "z<0"),
    ]);
}
