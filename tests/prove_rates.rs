//! Rates of what has an edge: |x|, √x, arcsin x may have a rate where their formulas for it have no value, as |x| has along x = 0 and
//! √x along x = t⁴. So nothing follows there from a formula for a rate, and no such rate tells that something is not 0.

use crate::prove_traps::all;

const STATES: &str = "t: time; x: state; y: state; u: state";

#[test]
fn a_rate_does_not_tell_that_its_formula_has_a_value() {
    all(&[
        // x = 0, u = 5: |x| = 0 has the rate 0.
        ("except", r"u+\frac{d}{dt}|x|-\frac{d}{dt}|x|=0", STATES, "xu=0"),
        ("except", r"u+0\frac{d}{dt}|x|=0", STATES, "xu=0"),
        ("except", r"u+\frac{d}{dt}(|x|y)-\frac{d}{dt}(|x|y)=0", STATES, "xu=0"),
        ("except", r"u+\frac{d}{dt}\sqrt x-\frac{d}{dt}\sqrt x=0", STATES, "xu=0"),
        ("unproved", r"u+0\frac{d}{dt}x^{\frac32}=0", STATES, "xu=0"),
        ("except", r"u+\frac{d}{dt}\arcsin x-\frac{d}{dt}\arcsin x=0", STATES, "(x^2-1)u=0"),
        ("except", r"u+\frac{d^2}{dt^2}(x|x|)-\frac{d^2}{dt^2}(x|x|)=0", STATES, "xu=0"),
        ("except", r"u+0\frac{d}{dt}\sqrt{x^2+y^2}=0", STATES, "(x^2+y^2)u=0"),
        // Along u = t, y = −t², x = −1 the rate is −π at t = 0.
        (
            "except",
            r"\frac{d}{dt}(u\operatorname{atan2}(y,x))=\dot u\operatorname{atan2}(y,x)+u\frac{x\dot y-y\dot x}{x^2+y^2}",
            STATES,
            "",
        ),
        ("unproved", r"u+0\frac{d}{dt}\lfloor x\rfloor=0", STATES, r"u\sin(\pi x)=0"),
        // The rate stands in what is given.
        ("except", "u=0", STATES, r"xu=0; \frac{d}{dt}|x|=y"),
        ("except", "u=0", STATES, r"xu=0; \dot y=\frac{d}{dt}|x|"),
        ("unproved", "u=0", STATES, r"xu=0; \frac{d}{dt}\sqrt x=y; \dot y=0"),
        // Fields: f = 0.
        (
            "unproved",
            r"u+\frac{\partial}{\partial x}|f|-\frac{\partial}{\partial x}|f|=0",
            "x: coordinate; u(x): field; f(x): field",
            "fu=0",
        ),
        // What is denied.
        ("unproved", r"x+0\frac{d}{dt}|x|\ne0", STATES, ""),
    ]);
}

#[test]
fn what_both_sides_need_anyway_is_no_exception() {
    all(&[
        ("proved", r"\frac{d}{dt}|x|=\frac{x\dot x}{|x|}", STATES, ""),
        ("proved", r"\frac{d}{dt}\sqrt x=\frac{\dot x}{2\sqrt x}", STATES, ""),
        ("proved", r"\frac{d}{dt}|x|=\dot x", STATES, "x>0"),
        // The time passes 1: there is no rate there.
        ("proved", r"(t-1)\frac{d}{dt}|t-1|=|t-1|", STATES, ""),
        ("proved", r"\frac1x\left(u+0\frac{d}{dt}|x|\right)=0", STATES, "xu=0"),
        ("except", r"\frac{d}{dt}|x|^3=3x|x|\dot x", STATES, ""),
    ]);
}
