//! Fields at other places: u(0, t), f(x − ct), V(q); what follows there, and what does not.
//!
//! Rows are those of [`prove_traps`](crate::prove_traps).

use crate::prove_traps::all;

#[test]
fn waves_of_any_shape() {
    let wave = "c; f(s), g(s): field; u(x,t): field = f(x-ct)+g(x+ct)";
    all(&[
        ("proved", r"\frac{\partial^2u}{\partial t^2}=c^2\frac{\partial^2u}{\partial x^2}", wave, ""),
        ("refuted", r"\frac{\partial^2u}{\partial t^2}=c\frac{\partial^2u}{\partial x^2}", wave, ""),
        ("refuted", r"\frac{\partial u}{\partial t}=-c\frac{\partial u}{\partial x}", wave, ""),
        ("proved", r"\partial_tf(x-ct)=-cf'(x-ct)", "c; t: coordinate; f(x): field", ""),
        ("refuted", r"\partial_tf(x-ct)=cf'(x-ct)", "c; t: coordinate; f(x): field", ""),
        ("proved", r"f(x-ct)=f(-tc+x)", "c; t: coordinate; f(x): field", ""),
        ("refuted", r"f(x-ct)=f(x+ct)", "c; t: coordinate; f(x): field", ""),
        ("proved", r"\partial_x^2f(ax+b)=a^2f''(ax+b)", "a, b; f(x): field", ""),
        ("refuted", r"\partial_x^2f(ax+b)=af''(ax+b)", "a, b; f(x): field", ""),
        ("proved", r"\partial_xf(g)=f'(g)g'", "g(x): field; f(s): field", ""),
        ("proved", r"\partial_x^2f(g)=f''(g)g'^2+f'(g)g''", "g(x): field; f(s): field", ""),
        ("refuted", r"\partial_x^2f(g)=f''(g)g'+f'(g)g''", "g(x): field; f(s): field", ""),
        // A spherical wave.
        (
            "proved",
            r"\nabla^2u=\frac{1}{c^2}\frac{\partial^2u}{\partial t^2}",
            r"x, y, z, t: coordinate; c; f(s): field; r = \sqrt{x^2+y^2+z^2}; u(x,y,z,t): field = \frac{f(r-ct)}{r}",
            "c>0",
        ),
        (
            "refuted",
            r"\nabla^2u=\frac{1}{c^2}\frac{\partial^2u}{\partial t^2}",
            r"x, y, z, t: coordinate; c; f(s): field; r = \sqrt{x^2+y^2+z^2}; u(x,y,z,t): field = f(r-ct)",
            "c>0",
        ),
    ]);
}

#[test]
fn boundary_data() {
    let string = r"u(x,t): field; c";
    all(&[
        ("refuted", r"u(0,t)=0", "u(x,t): field", ""),
        ("refuted", r"u(0,t)=u", "u(x,t): field", ""),
        ("refuted", r"\left.u\right|_{x=0}=u", "u(x,t): field", ""),
        ("refuted", r"\left.u\right|_{t=0}=u", "t: time; u(x,t): field", ""),
        ("proved", r"\left.u\right|_{x=0}=u(0,t)", "u(x,t): field", ""),
        ("proved", r"\left.\partial_xu\right|_{x=0}=u_x(0,t)", "u(x,t): field", ""),
        ("refuted", r"\left.\partial_xu\right|_{x=0}=0", "u(x,t): field", ""),
        ("proved", r"u_t(0,t)=0", "u(x,t): field", r"u(0,t)=0"),
        ("unproved", r"u_x(0,t)=0", "u(x,t): field", r"u(0,t)=0"),
        ("unproved", r"u=0", "u(x,t): field", r"u(0,t)=0"),
        ("unproved", r"u(1,t)=0", "u(x,t): field", r"u(0,t)=0"),
        // The equation holds at the end of the string, too.
        ("proved", r"u_{xx}(0,t)=0", string, r"c>0; \partial_t^2u=c^2\partial_x^2u; u(0,t)=0"),
        ("proved", r"u_{xxtt}(0,t)=0", string, r"c>0; \partial_t^2u=c^2\partial_x^2u; u(0,t)=0"),
        ("proved", r"u_{xxx}(0,t)=0", string, r"c>0; \partial_t^2u=c^2\partial_x^2u; u_x(0,t)=0"),
        ("unproved", r"u_{xxx}(0,t)=0", string, r"c>0; \partial_t^2u=c^2\partial_x^2u; u(0,t)=0"),
        // Where it is given for x > 0 only, it need not.
        ("unproved", r"u_{xx}(0,t)=0", string, r"c>0; x>0; \partial_t^2u=c^2\partial_x^2u; u(0,t)=0"),
        ("unproved", r"u_x(0,t)=1", "u(x,t): field", r"xu_x=x"),
        ("unproved", r"u(0,t)=0", "u(x,t): field", r"u=\frac{x^2}{x}"),
        // What is true of a field is true of its values, whatever a point says.
        ("unrefuted", r"u(0,t)=u", "u(x,t): field", r"u_x=0"),
        ("unrefuted", r"f(x-ct)=f(0)", "t: coordinate; c; f(x): field", r"f'=0"),
        ("unrefuted", r"f(ax)=f(0)", "a; f(x): field", "a=0"),
        ("unrefuted", r"f(a)=f(b)", "a, b; f(x): field", "a=b"),
        ("unrefuted", r"f(a)=f(b)", "a, b; f(x): field", "a^3=b^3"),
        ("unproved", r"f(a)=f(b)", "a, b; f(x): field", "a^2=b^2"),
        ("unrefuted", r"f(\sin^2x)=f(1-\cos^2x)", "f(x): field", ""),
        ("refuted", r"f(\sin^2x)=f(\cos^2x)", "f(x): field", ""),
        ("unproved", r"f(\sqrt{x^2})=f(x)", "f(x): field", ""),
        ("refuted", r"f(2x)=2f(x)", "f(x): field", ""),
        ("unrefuted", r"f(2x)=2f(x)", "c; f(x): field", "f=cx"),
        ("proved", r"f(2x)=2f(x)", "c; f(x): field", "f=cx"),
        ("unproved", r"f(2x)=2f(x)", "c; f(x): field", "f=cx^2"),
    ]);
}

#[test]
fn unknown_potentials() {
    let one = "q: state; m: positive; V(x): field";
    let newton = r"m\ddot q=-V'(q)";
    let two = "q, s: state; m: positive; V(x): field; L = \\frac12m\\dot q^2+\\frac12m\\dot s^2-V(q-s)";
    all(&[
        ("proved", r"\frac{d}{dt}\left(\frac12m\dot q^2+V(q)\right)=0", one, newton),
        ("unproved", r"\frac{d}{dt}\left(\frac12m\dot q^2-V(q)\right)=0", one, newton),
        ("proved", r"m\frac{d^3q}{dt^3}=-V''(q)\dot q", one, newton),
        ("unproved", r"m\frac{d^3q}{dt^3}=-V''(q)", one, newton),
        ("proved", r"m\ddot q=-kq", "q: state; m: positive; k; V(x): field", r"m\ddot q=-V'(q); V=\frac12kx^2"),
        ("unproved", r"m\ddot q=kq", "q: state; m: positive; k; V(x): field", r"m\ddot q=-V'(q); V=\frac12kx^2"),
        (
            "proved",
            r"\frac{\delta L}{\delta q}=-m\ddot q-V'(q)",
            r"q: state; m; V(x): field; L = \frac12m\dot q^2-V(q)",
            "",
        ),
        (
            "refuted",
            r"\frac{\delta L}{\delta q}=-m\ddot q+V'(q)",
            r"q: state; m; V(x): field; L = \frac12m\dot q^2-V(q)",
            "",
        ),
        ("proved", r"\frac{\partial L}{\partial q}=-V'(q)", r"q: state; m; V(x): field; L = \frac12m\dot q^2-V(q)", ""),
        // Noether: only the distance counts.
        ("proved", r"m\ddot q+m\ddot s=0", two, r"\frac{\delta L}{\delta q}=0; \frac{\delta L}{\delta s}=0"),
        ("unproved", r"m\ddot q-m\ddot s=0", two, r"\frac{\delta L}{\delta q}=0; \frac{\delta L}{\delta s}=0"),
        // Two fields, and one of a field.
        (
            "proved",
            r"\frac{\delta L}{\delta\phi}=\partial_x^2\phi-\partial_t^2\phi-V'(\phi)",
            r"\phi(x,t): field; V(s): field; L = \frac12(\partial_t\phi)^2-\frac12(\partial_x\phi)^2-V(\phi)",
            "",
        ),
        (
            "proved",
            r"\partial_t\left(\frac12(\partial_t\phi)^2+\frac12(\partial_x\phi)^2+V(\phi)\right)=\partial_x(\partial_t\phi\,\partial_x\phi)",
            r"\phi(x,t): field; V(s): field",
            r"\partial_t^2\phi=\partial_x^2\phi-V'(\phi)",
        ),
        (
            "unproved",
            r"\partial_t\left(\frac12(\partial_t\phi)^2+\frac12(\partial_x\phi)^2-V(\phi)\right)=\partial_x(\partial_t\phi\,\partial_x\phi)",
            r"\phi(x,t): field; V(s): field",
            r"\partial_t^2\phi=\partial_x^2\phi-V'(\phi)",
        ),
        // Hamilton's equations with any potential, and a central force.
        (
            "proved",
            r"\{p,H\}=-V'(q)",
            r"q: state; p: state, momentum of q; m; V(x): field; H = \frac{p^2}{2m}+V(q)",
            "",
        ),
        (
            "refuted",
            r"\{p,H\}=V'(q)",
            r"q: state; p: state, momentum of q; m; V(x): field; H = \frac{p^2}{2m}+V(q)",
            "",
        ),
        (
            "proved",
            r"\{L_3,H\}=0",
            r"{\bf q}: state, 3; {\bf p}: state, 3, momentum of {\bf q}; m; V(s): field; {\bf L} = {\bf q}\times{\bf p}; H = \frac{{\bf p}^2}{2m}+V({\bf q}^2)",
            "",
        ),
        (
            "refuted",
            r"\{L_3,H\}=0",
            r"{\bf q}: state, 3; {\bf p}: state, 3, momentum of {\bf q}; m; V(s): field; {\bf L} = {\bf q}\times{\bf p}; H = \frac{{\bf p}^2}{2m}+V(q_1)",
            "",
        ),
        // Along a motion, a field changes at its place and by the place.
        ("proved", r"\frac{d}{dt}u(q,t)=u_t(q,t)+\dot qu_x(q,t)", "q: state; t: time; u(x,t): field", ""),
        ("refuted", r"\frac{d}{dt}u(q,t)=u_t(q,t)", "q: state; t: time; u(x,t): field", ""),
    ]);
}

#[test]
fn places_that_are_refused() {
    let refused = |text: &str, symbols: &str| {
        let mut derivation = rederive::derivation::Derivation::blank();
        let typed: Vec<(String, String)> = symbols.split("; ").map(|s| (s.to_owned(), s.to_owned())).collect();
        derivation.declare_typed(&typed).expect("symbols");
        let proposition =
            rederive::check::Proposition { formula: text.to_owned(), given: Vec::new(), throughout: false };
        assert!(rederive::check::prove(&mut derivation, &proposition).is_err(), "{text}, {symbols}: it is read");
    };
    for (text, symbols) in [
        // The derivative at a place, or that of a value?
        (r"\partial_xu(0,t)=0", "u(x,t): field"),
        (r"\partial_xu(y,t)=0", "u(x,t): field; y: coordinate"),
        (r"\frac{d}{dx}f(0)=0", "f(x): field"),
        (r"f(\pm x)=0", "f(x): field"),
        (r"\left.u\right|_{y=0}=0", "u(x,t): field; y: coordinate"),
        (r"\left.q\right|_{x=0}=0", "u(x,t): field; q: state"),
        (r"u(z)=0", "u(x,t): field; z: complex"),
        // Whether it depends on a parameter otherwise is not said.
        (r"\frac{\partial}{\partial c}f(x-ct)=0", "f(x): field; t: coordinate; c"),
        (r"\frac{\delta L}{\delta u}=0", "u(x,t): field; L = uu(0,t)"),
    ] {
        refused(text, symbols);
    }
}

#[test]
fn transformed_solutions() {
    all(&[
        (
            "proved",
            r"\partial_x^2w+\partial_y^2w=0",
            r"\phi(x,y): field; w(x,y): field = \phi(\frac{x}{x^2+y^2},\frac{y}{x^2+y^2})",
            r"\partial_x^2\phi+\partial_y^2\phi=0",
        ),
        (
            "unproved",
            r"\partial_x^2w+\partial_y^2w=0",
            r"\phi(x,y): field; w(x,y): field = \phi(2x,y)",
            r"\partial_x^2\phi+\partial_y^2\phi=0",
        ),
        ("proved", r"\nabla^2\phi(-x,y,z)=0", r"\phi(x,y,z): field", r"\nabla^2\phi=0"),
        ("unproved", r"\nabla^2\phi(2x,y,z)=0", r"\phi(x,y,z): field", r"\nabla^2\phi=0"),
        // Galilei: what is carried along moves on.
        (
            "proved",
            r"\partial_tw+a\partial_xw+w\partial_xw=0",
            "t, x: coordinate; a; u(x,t): field; w(x,t): field = u(x-at,t)",
            r"\partial_tu+u\partial_xu=0",
        ),
        (
            "unproved",
            r"\partial_tw+w\partial_xw=0",
            "t, x: coordinate; a; u(x,t): field; w(x,t): field = u(x-at,t)",
            r"\partial_tu+u\partial_xu=0",
        ),
        ("refuted", r"\partial_y\partial_xh(y,x)=\partial_x\partial_yh", "h(x,y): field", ""),
        ("proved", r"\partial_y\partial_xh(y,x)=h_{xy}(y,x)", "h(x,y): field", ""),
    ]);
}

#[test]
fn traps_of_fields() {
    all(&[
        // Conditions of integrability that leave nothing.
        ("proved", r"u=0", "u(x,y): field", r"u_x=yu; u_y=u"),
        ("unproved", r"1=2", "u(x,y): field", r"u_x=y; u_y=-x"),
        ("unproved", r"u=1", "u(x,y): field", r"u_x=y; u_y=-x"),
        // Values on the rim decide, and no local solution speaks against it.
        ("unrefuted", r"u=0", "u(x,y): field", r"\nabla^2u=0; u(0,y)=0; u(1,y)=0"),
        ("unproved", r"u=0", "u(x,t): field", r"u_t=u_{xx}; u(0,t)=0"),
        // Boundary terms: what a density gains is no derivative of it.
        ("refuted", r"\frac{\delta L}{\delta q}=\frac{\partial L}{\partial q}", r"q: state; t: time; L = q\dot qt", ""),
        ("proved", r"\frac{\delta L}{\delta q}=-q", r"q: state; t: time; L = q\dot qt", ""),
        // An axis, a pole, an origin.
        ("unproved", r"\left.r\partial_rf\right|_{r=0}=1", "r: coordinate; f(r): field", r"r\partial_rf=r"),
        ("unrefuted", r"f(0)=f(0)", "f(r): field", r"f=\frac{\sin r}{r}"),
        ("unproved", r"f(0)=0", "f(r): field", r"rf=r^2"),
    ]);
}

#[test]
fn places_that_are_the_same_and_places_in_places() {
    all(&[
        // At its own coordinates a field is itself.
        ("proved", r"\left.u(y,t)\right|_{y=x}=u", "u(x,t): field; y: coordinate", ""),
        ("proved", r"\left.\frac{\partial u(y,t)}{\partial y}\right|_{y=x}=u_x", "u(x,t): field; y: coordinate", ""),
        // Values of two fields at one place have nothing to do with each other.
        ("refuted", r"f(0)=g(0)", "f(x), g(x): field", ""),
        ("refuted", r"f(0)=f(1)", "f(x): field", ""),
        ("proved", r"f(0)=f(2-2)", "f(x): field", ""),
        // What stands in a place that stands in a place.
        ("proved", r"\frac{\partial}{\partial q}f(g(q))=f'(g(q))g'(q)", "f(x), g(x): field; q: state", ""),
        ("proved", r"\frac{d}{dt}f(g(q))=\dot qf'(g(q))g'(q)", "f(x), g(x): field; q: state", ""),
        ("refuted", r"\frac{\partial}{\partial q}f(g(q))=f'(g(q))", "f(x), g(x): field; q: state", ""),
    ]);
}

#[test]
fn functions_of_what_moves() {
    let lagrange = r"t: time; q: state; L(q,\dot q,t): field";
    let hamilton = r"t: time; q, p: state; H(q,p): field";
    let motion = r"\dot q=\frac{\partial H}{\partial p}; \dot p=-\frac{\partial H}{\partial q}";
    all(&[
        ("refuted", r"\frac{\partial L}{\partial q}=\frac{\partial L}{\partial\dot q}", lagrange, ""),
        ("refuted", r"\frac{\partial L}{\partial\dot q}=0", lagrange, ""),
        (
            "proved",
            r"\frac{dL}{dt}=\frac{\partial L}{\partial q}\dot q+\frac{\partial L}{\partial\dot q}\ddot q+\frac{\partial L}{\partial t}",
            lagrange,
            "",
        ),
        (
            "refuted",
            r"\frac{dL}{dt}=\frac{\partial L}{\partial q}\dot q+\frac{\partial L}{\partial\dot q}\ddot q",
            lagrange,
            "",
        ),
        ("proved", r"L(q,\dot q,t)=L", lagrange, ""),
        ("refuted", r"L(\dot q,q,t)=L", lagrange, ""),
        ("proved", r"\frac{dH}{dt}=0", hamilton, motion),
        ("unproved", r"\frac{dH}{dt}=0", r"t: time; q, p: state; H(q,p,t): field", motion),
        ("refuted", r"\frac{dH}{dt}=0", hamilton, ""),
    ]);
}

#[test]
fn functions_share_no_places() {
    let moving = r"t: time; r, s: state; V(r): field";
    let beside = r"t: time; x: coordinate; f(x): field; r: state; V(r): field";
    let number = r"x: coordinate; f(x): field; a: parameter; k(a): field";
    all(&[
        ("proved", r"V(r)=V", moving, ""),
        ("refuted", r"V(s)=V", moving, ""),
        ("proved", r"V'(r)=\frac{\partial V}{\partial r}", moving, ""),
        ("refuted", r"V'(s)=V'", moving, ""),
        ("proved", r"\frac{d}{dt}V(r)=V'\dot r", moving, ""),
        ("refuted", r"\dot V=V'", moving, ""),
        ("refuted", r"V(r)=f(r)", beside, ""),
        ("refuted", r"V'=f'", beside, ""),
        ("refuted", r"V'=0", beside, ""),
        ("proved", r"V'(x)=\partial_xV(x)", beside, ""),
        ("refuted", r"k=f", number, ""),
        ("refuted", r"k(x)=f(x)", number, ""),
        ("refuted", r"k'=0", number, ""),
    ]);
}
