//! Fields: derivatives, what follows from partial differential equations, and what does not.
//!
//! Rows are those of [`prove_traps`](crate::prove_traps).

use crate::prove_traps::all;

#[test]
fn fields_by_themselves() {
    all(&[
        ("proved", r"\partial_x\partial_yu=\frac{\partial^2u}{\partial y\partial x}", "u(x,y): field", ""),
        ("proved", r"\frac{\partial}{\partial x}(uv)=u\partial_xv+v\partial_xu", "u(x,y), v(x,y): field", ""),
        ("proved", r"\nabla\times\nabla f=0", "f(x,y,z): field", ""),
        ("proved", r"\nabla\cdot(\nabla\times{\bf A})=0", r"{\bf A}(x,y,z): field, 3", ""),
        (
            "proved",
            r"\nabla\times(\nabla\times{\bf A})=\nabla(\nabla\cdot{\bf A})-\nabla^2{\bf A}",
            r"{\bf A}(x,y,z): field, 3",
            "",
        ),
        (
            "proved",
            r"\nabla\cdot({\bf A}\times{\bf B})={\bf B}\cdot(\nabla\times{\bf A})-{\bf A}\cdot(\nabla\times{\bf B})",
            r"{\bf A}(x,y,z), {\bf B}(x,y,z): field, 3",
            "",
        ),
        (
            "proved",
            r"({\bf A}\cdot\nabla){\bf A}=\nabla\left(\frac12{\bf A}^2\right)-{\bf A}\times(\nabla\times{\bf A})",
            r"{\bf A}(x,y,z): field, 3",
            "",
        ),
        ("refuted", r"\nabla\cdot(u{\bf A})=u\nabla\cdot{\bf A}", r"{\bf A}(x,y,z): field, 3; u(x,y,z): field", ""),
        ("refuted", r"\partial_xu=0", "u(x,t): field", ""),
        ("proved", r"u_{xt}=\partial_t\partial_xu", "u(x,t): field", ""),
        ("refuted", r"u_x=u_t", "u(x,t): field", ""),
        ("proved", r"g_x(0,t)=\cos ct", r"g(x,t): field = \sin(x-ct); c", ""),
        ("refuted", r"u=0", "u(x,t): field", ""),
        ("refuted", r"\partial_x(\partial_tu)^2=(\partial_x\partial_tu)^2", "u(x,t): field", ""),
        ("proved", r"\nabla^2\frac1r=0", r"r = \sqrt{x^2+y^2+z^2}; x, y, z: coordinate", ""),
        ("refuted", r"\nabla^2\frac1r=0", r"r = \sqrt{x^2+y^2}; x, y: coordinate", ""),
        ("proved", r"\partial_t^2u=c^2\partial_x^2u", r"u(x,t): field = \sin(x-ct); c", ""),
        ("refuted", r"\partial_t^2u=c\partial_x^2u", r"u(x,t): field = \sin(x-ct); c", ""),
        ("proved", r"g(x,0)=x^2", r"g(x,t): field = x^2e^{-t}", ""),
        ("proved", r"g(y,0)=y^2", r"g(x,t): field = x^2e^{-t}; y", ""),
        ("refuted", r"\partial_x|u|=\partial_xu", "u(x,t): field", ""),
        ("proved", r"\partial_x|u|=\partial_xu", "u(x,t): field", "u>0"),
        ("proved", r"\partial_x\psi^*=(\partial_x\psi)^*", r"\psi(x,t): field, complex", ""),
        ("refuted", r"\partial_x|\psi|^2=2\psi^*\partial_x\psi", r"\psi(x,t): field, complex", ""),
        ("refuted", r"\dot u=\partial_xu", "u(x,t): field", ""),
        ("proved", r"\frac{d^2}{dx^2}(uv)=u''v+2u'v'+uv''", "u(x), v(x): field", ""),
        ("proved", r"\partial_x\ln u=\frac{\partial_xu}{u}", "u(x,t): field", ""),
        ("refuted", r"\partial_x|x|=1", "x: coordinate", ""),
        ("proved", r"\partial_x|x|=1", "x: coordinate", "x>0"),
        ("proved", r"\nabla\cdot\frac{{\bf r}}{r^3}=0", r"{\bf r}: coordinate, 3; r = |{\bf r}|", ""),
        ("proved", r"\nabla\times({\bf w}\times{\bf r})=2{\bf w}", r"{\bf r}: coordinate, 3; {\bf w}: 3", ""),
        (
            "proved",
            r"\frac{\partial A_i}{\partial r_i}=\nabla\cdot A",
            r"{\bf r}: coordinate, 3; A({\bf r}): field, 3",
            "",
        ),
    ]);
}

#[test]
fn what_follows_from_equations_of_fields() {
    all(&[
        ("proved", r"\partial_x^2u=\partial_t^2u", "u(x,t): field", r"\partial_tu=\partial_xu"),
        ("proved", r"\partial_x^3u=\partial_t^3u", "u(x,t): field", r"\partial_tu=\partial_xu"),
        ("refuted", r"\partial_tu=\partial_xu", "u(x,t): field", r"\partial_x^2u=\partial_t^2u"),
        ("proved", r"\dot u=0", "u(x,t): field", "u=5"),
        ("proved", r"f''=f", "f(x): field", "f'=f"),
        ("refuted", r"f''=-f", "f(x): field", "f'=f"),
        // f = 1.
        ("unproved", r"f''=-f", "f(x): field", "f'^2=1-f^2"),
        // Integrability.
        ("proved", r"u=0", "u(x,y): field", r"\partial_xu=yu; \partial_yu=u"),
        ("unproved", r"u=0", "u(x,y): field", r"\partial_xu=y; \partial_yu=-x"),
        ("unproved", r"1=0", "u(x,y): field", r"\partial_xu=y; \partial_yu=-x"),
        ("proved", r"\partial_yv=\partial_xw", "u(x,y), v(x,y), w(x,y): field", r"\partial_xu=v; \partial_yu=w"),
        ("unrefuted", r"\partial_yv=\partial_xw", "u(x,y), v(x,y), w(x,y): field", r"v=\partial_xu; w=\partial_yu"),
        // Cauchy and Riemann.
        ("proved", r"\nabla^2u=0", "u(x,y), v(x,y): field", r"\partial_xu=\partial_yv; \partial_yu=-\partial_xv"),
        ("refuted", r"u=v", "u(x,y), v(x,y): field", r"\partial_xu=\partial_yv; \partial_yu=-\partial_xv"),
        ("refuted", r"u=0", "u(x,y): field", r"\nabla^2u=0"),
        ("refuted", r"\partial_tu=0", "u(x,t): field", r"\partial_tu=\partial_x^2u"),
        // A sum of squares.
        ("proved", r"\partial_xu=0", "u(x,t): field", r"(\partial_xu)^2+(\partial_tu)^2=0"),
        ("unrefuted", r"\partial_x^2u=0", "u(x,t): field", r"(\partial_xu)^2+(\partial_tu)^2=0"),
        ("unrefuted", r"\partial_x^2u=0", "u(x,t): field", r"(\partial_xu)^2=0"),
        // An equation between coordinates holds at some places, and is not derived; nor is what is given there.
        ("proved", r"u=0", "u(x,t): field", "u=x; x=0"),
        ("unproved", r"\partial_xu=1", "u(x,t): field", "u=x; x=0"),
        ("undecided", r"\partial_xu=0", "u(x,t): field", "u=0; x=0"),
        ("undecided", r"\partial_tu=0", "u(x,t): field", "u=0; x=t"),
        ("undecided", r"\partial_xu=2x", "u(x,t): field", "u=x^2; t=x"),
        ("unproved", r"\partial_xu=0", "u(x,t): field", "u=x; x=0"),
        ("unproved", r"\partial_xu=0", "u(x,t): field", "x=t"),
        ("unproved", r"1=0", "u(x,t): field", "x=t; u=1"),
        // What moves is the same at all places.
        ("unrefuted", r"\partial_xu=0", "u(x,t): field; q: state", "u=q"),
        ("unproved", r"\partial_tu=0", "u(x,t): field; q: state", "u=q"),
        // Fields of fewer coordinates.
        ("proved", r"\partial_x\partial_yu=0", "u(x,y), f(x), g(y): field", "u=f+g"),
        ("proved", r"f'=0", "f(x), g(y): field", "f=g"),
        ("unrefuted", r"f=0", "f(x): field; y: coordinate", "f=y"),
        ("unrefuted", r"f=c", "f(x), g(y): field; c", "f=g; f=c"),
        // Maxwell's relation of thermodynamics, and what follows from it.
        (
            "proved",
            r"\frac{\partial p}{\partial T}=\frac{\partial S}{\partial V}",
            "p(T,V), S(T,V), F(T,V): field",
            r"p=-\frac{\partial F}{\partial V}; S=-\frac{\partial F}{\partial T}",
        ),
        (
            "proved",
            r"\frac{\partial U}{\partial V}=T\frac{\partial p}{\partial T}-p",
            "p(T,V), S(T,V), F(T,V), U(T,V): field",
            r"p=-\frac{\partial F}{\partial V}; S=-\frac{\partial F}{\partial T}; U=F+TS",
        ),
        (
            "proved",
            r"\left(\frac{\partial S}{\partial V}\right)_T=\left(\frac{\partial p}{\partial T}\right)_V",
            "p(T,V), S(T,V), F(T,V): field",
            r"p=-\left(\frac{\partial F}{\partial V}\right)_T; S=-\left(\frac{\partial F}{\partial T}\right)_V",
        ),
        // Inequalities that hold at a point need not hold around it.
        ("unrefuted", r"\partial_xu=0", "u(x): field", r"u\ge 0; u\le 0"),
        ("unrefuted", r"\partial_xu=0", "u(x): field", r"u^2\le 0"),
        ("unrefuted", r"\partial_xu=0", "u(x): field", r"\sqrt{-u^2}\ge 0"),
        ("unrefuted", r"\partial_xu=0", "u(x): field", r"\arcsin(1+u^2)\ge 0"),
        ("unrefuted", r"\partial_xu=0", "u(x), v(x): field", r"u^2+v^2=1; v\ge 1"),
        ("unrefuted", r"\partial_xu+\sqrt{-u}=0", "u(x): field", r"u\ge 0"),
        ("unrefuted", r"\dot q=0", "q: state", r"q\ge 1; q\le 1"),
        ("unrefuted", r"\dot x=\dot y", "x, y: state", r"x\le y\le x"),
        ("refuted", r"\partial_xu=0", "u(x): field", r"u\ge 0"),
        ("refuted", r"\dot q=0", "q: state", r"q\ge 0; q\le 1"),
        // What moves is nowhere tied to a place.
        ("unproved", r"\dot q=0", "t: time; x: coordinate; q: state", "q=x"),
        ("unrefuted", r"q=0", "t: time; x: coordinate; q: state", "q=x"),
        // No theorem says that there is a solution.
        ("undecided", r"u=1", "u(x,t): field", r"\partial_tu=\sqrt{u}"),
        // A field that is defined by another.
        (
            "proved",
            r"\partial_tu+u\partial_xu=\nu\partial_x^2u",
            r"u(x,t), \phi(x,t): field; \nu: positive",
            r"\partial_t\phi=\nu\partial_x^2\phi; u=-\frac{2\nu}{\phi}\partial_x\phi",
        ),
        (
            "refuted",
            r"\partial_tu=\nu\partial_x^2u",
            r"u(x,t), \phi(x,t): field; \nu: positive",
            r"\partial_t\phi=\nu\partial_x^2\phi; u=-\frac{2\nu}{\phi}\partial_x\phi",
        ),
        // It names the derivative that leads another equation.
        ("unproved", r"u=0", r"u(x,t), \phi(x,t): field", r"\partial_t\phi=\partial_x^2\phi; u=\partial_x^2\phi"),
        // Waves of a medium.
        (
            "proved",
            r"\partial_t^2u=c^2\partial_x^2u",
            "u(x,t), v(x,t): field; c",
            r"\partial_tu=c\partial_xv; \partial_tv=c\partial_xu",
        ),
        (
            "refuted",
            r"\partial_t^2u=c\partial_x^2u",
            "u(x,t), v(x,t): field; c",
            r"\partial_tu=c\partial_xv; \partial_tv=c\partial_xu",
        ),
        (
            "proved",
            r"\partial_t|\psi|^2+\partial_x\left(\frac{h}{m}\operatorname{Im}(\psi^*\partial_x\psi)\right)=0",
            r"\psi(x,t): field, complex; V(x): field; h, m: positive",
            r"\mathrm ih\partial_t\psi=-\frac{h^2}{2m}\partial_x^2\psi+V\psi",
        ),
        // Without what makes it real, the potential is a source.
        (
            "refuted",
            r"\partial_t|\psi|^2+\partial_x\left(\frac{h}{m}\operatorname{Im}(\psi^*\partial_x\psi)\right)=0",
            r"\psi(x,t), V(x,t): field, complex; h, m: positive",
            r"\mathrm ih\partial_t\psi=-\frac{h^2}{2m}\partial_x^2\psi+V\psi",
        ),
    ]);
}

/// Indices at ∂ run over Cartesian coordinates of space.
#[test]
fn derivatives_with_indices() {
    let space = r"x, y, z: coordinate; A(x,y,z,t), B(x,y,z,t): field, 3; u(x,y,z,t), v(x,y,z,t): field";
    let plane = r"x, y: coordinate; A(x,y): field, 2; u(x,y): field";
    let places = r"{\bf r}: coordinate, 3; A({\bf r}): field, 3; {\bf w}: 3";
    all(&[
        ("proved", r"\partial_iA_i=\nabla\cdot A", space, ""),
        ("proved", r"\partial_iA_i=\nabla\cdot A", plane, ""),
        ("proved", r"\partial_i\partial_iu=\nabla^2u", space, ""),
        ("proved", r"\partial_i^2u=\nabla^2u", space, ""),
        ("proved", r"\partial_iu=(\nabla u)_i", space, ""),
        ("proved", r"\epsilon_{ijk}\partial_jA_k=(\nabla\times A)_i", space, ""),
        ("refuted", r"\epsilon_{ijk}\partial_jA_k=-(\nabla\times A)_i", space, ""),
        ("refuted", r"\epsilon_{ijk}\partial_kA_j=(\nabla\times A)_i", space, ""),
        ("proved", r"\partial_i(uA_i)=u\partial_iA_i+A_i\partial_iu", space, ""),
        ("refuted", r"\partial_i(uA_i)=u\partial_iA_i", space, ""),
        ("proved", r"\partial_i\partial_jA_j=\partial_j\partial_iA_j", space, ""),
        ("proved", r"\epsilon_{ijk}\partial_i\partial_jA_k=0", space, ""),
        ("proved", r"\partial_iu\,\partial_iv=(\nabla u)\cdot(\nabla v)", space, ""),
        ("proved", r"(\partial_iu)(\partial_iu)=(\nabla u)^2", space, ""),
        ("proved", r"A_j\partial_jA_i=((A\cdot\nabla)A)_i", space, ""),
        ("proved", r"\partial_jA_i-\partial_iA_j=\epsilon_{jik}(\nabla\times A)_k", space, ""),
        ("proved", r"\partial_{ij}u=\partial_i\partial_ju", space, ""),
        ("proved", r"\partial_t\partial_iA_i=\partial_i\partial_tA_i", space, ""),
        ("proved", r"\partial_ir_j=\delta_{ij}", places, ""),
        ("proved", r"\partial_i(\epsilon_{ijk}w_jr_k)=0", places, ""),
        ("proved", r"\partial_iA_i=\frac{\partial A_i}{\partial r_i}", places, ""),
        ("proved", r"\partial_t\partial_iA_i=0", space, r"\partial_iA_i=0"),
        ("refuted", r"A_1=0", space, r"\partial_iA_i=0"),
        ("proved", r"\partial_tu+\partial_i(uA_i)=0", space, r"\partial_tu+A_i\partial_iu=0; \partial_iA_i=0"),
    ]);
}

/// Equations that lead with derivatives of one field: passive as they are, or with what follows from two of them.
#[test]
fn systems_that_are_made_passive() {
    let maxwell = r"{\bf E}(x,y,z,t), {\bf B}(x,y,z,t): field, 3; c: positive";
    let vacuum = r"\nabla\cdot{\bf E}=0; \nabla\cdot{\bf B}=0; \nabla\times{\bf E}=-\partial_t{\bf B}; c^2\nabla\times{\bf B}=\partial_t{\bf E}";
    let turned = r"\nabla\cdot{\bf E}=0; \nabla\cdot{\bf B}=0; \nabla\times{\bf E}=\partial_t{\bf B}; c^2\nabla\times{\bf B}=\partial_t{\bf E}";
    let fluid = r"{\bf v}(x,y,z,t): field, 3; p(x,y,z,t): field";
    let euler = r"\partial_t{\bf v}+({\bf v}\cdot\nabla){\bf v}=-\nabla p; \nabla\cdot{\bf v}=0";
    let wave = r"\nabla^2{\bf E}=\frac{1}{c^2}\partial_t^2{\bf E}";
    let vorticity = r"\partial_t(\nabla\times{\bf v})=\nabla\times({\bf v}\times(\nabla\times{\bf v}))";
    all(&[
        ("proved", wave, maxwell, vacuum),
        ("refuted", r"\nabla^2{\bf E}=-\frac{1}{c^2}\partial_t^2{\bf E}", maxwell, vacuum),
        ("refuted", r"\nabla^2{\bf E}=\frac{2}{c^2}\partial_t^2{\bf E}", maxwell, vacuum),
        ("refuted", r"{\bf E}\cdot{\bf B}=0", maxwell, vacuum),
        ("refuted", r"\partial_t({\bf E}^2+c^2{\bf B}^2)=2c^2\nabla\cdot({\bf E}\times{\bf B})", maxwell, vacuum),
        ("proved", r"\partial_t({\bf E}^2+c^2{\bf B}^2)=-2c^2\nabla\cdot({\bf E}\times{\bf B})", maxwell, vacuum),
        ("refuted", wave, maxwell, turned),
        ("proved", r"\nabla^2{\bf E}=-\frac{1}{c^2}\partial_t^2{\bf E}", maxwell, turned),
        ("proved", vorticity, fluid, euler),
        ("refuted", r"\partial_t{\bf v}=-\nabla p", fluid, euler),
        // What is added: an equation for the pressure.
        ("proved", r"\nabla^2p=-\nabla\cdot(({\bf v}\cdot\nabla){\bf v})", fluid, euler),
        ("refuted", r"\nabla^2p=\nabla\cdot(({\bf v}\cdot\nabla){\bf v})", fluid, euler),
        ("refuted", r"\nabla^2p=0", fluid, euler),
        // It is derived, too: at no point of a solution is this false.
        ("unrefuted", r"\partial_t\nabla^2p=-\partial_t\nabla\cdot(({\bf v}\cdot\nabla){\bf v})", fluid, euler),
        ("refuted", r"u=0", "u(x,y): field", r"\partial_xu=2xu; \partial_yu=u"),
        ("refuted", r"f'=0", "u(x,y), f(x), g(y): field", r"\partial_xu=f; \partial_yu=g"),
        ("proved", r"f'=0", "u(x,y), f(x): field", r"\partial_xu=f; \partial_yu=f"),
        ("refuted", r"f=0", "u(x,y), f(x): field", r"\partial_xu=f; \partial_yu=f"),
        ("proved", r"x\partial_xv=y\partial_yv", "u(x,y), v(x,y): field", r"\partial_xu=yv; \partial_yu=xv"),
        ("refuted", r"v=1", "u(x,y), v(x,y): field", r"\partial_xu=yv; \partial_yu=xv"),
        // Only u = 0: two steps of completion lead there.
        ("unrefuted", r"u=0", "u(x,y): field", r"\partial_x^2u=yu; \partial_y^2u=xu"),
        ("unrefuted", r"\partial_xu=0", "u(x,y): field", r"\partial_x^2u=yu; \partial_y^2u=xu"),
        // Janet's example: the solutions are twelve functions, polynomials of low degree.
        ("unrefuted", r"\partial_x^4u=0", "u(x,y,z): field", r"\partial_z^2u=y\partial_x^2u; \partial_y^2u=0"),
        // Contradictory, or for special values of what is constant.
        (
            "unrefuted",
            r"u=0",
            "u(x,y), v(x,y), w(x,y): field",
            r"\partial_xu=v; \partial_yu=w; \partial_yv=\partial_xw+1",
        ),
        ("unrefuted", r"abu=c", "u(x,y): field; a, b, c", r"\partial_xu=au; \partial_yu=bu; \partial_x\partial_yu=c"),
        ("refuted", r"u=1", "u(x,t): field; c", r"\partial_t^2u=\partial_x^2u; \partial_t^2u=c^2\partial_x^2u; c^2=1"),
        (
            "unrefuted",
            r"(c^2-1)\partial_x^2u=0",
            "u(x,t): field; c",
            r"\partial_t^2u=\partial_x^2u; \partial_t^2u=c^2\partial_x^2u",
        ),
        // A proof does not say less because of what it adds.
        ("proved", r"k\partial_yv=k\partial_xw", "u(x,y), v(x,y), w(x,y): field; k", r"k\partial_xu=v; k\partial_yu=w"),
        ("proved", r"\partial_yv=\partial_xw", "u(x,y), v(x,y), w(x,y): field; k", r"k\partial_xu=v; k\partial_yu=w"),
        // A field that does not depend on the time leads nothing that does.
        (
            "refuted",
            r"\partial_t{\bf v}=-\nabla p",
            r"{\bf v}(x,y,z,t): field, 3; p(x,y,z,t): field; U(x,y,z): field",
            r"\partial_t{\bf v}+({\bf v}\cdot\nabla){\bf v}=-\nabla p-\nabla U; \nabla\cdot{\bf v}=0",
        ),
        // Not linear in what leads: no theorem.
        ("undecided", r"u=1", "u(x,y): field", r"(\partial_xu)^2=u; (\partial_yu)^2=u"),
    ]);
}

#[test]
fn what_says_too_little_is_refused() {
    for (text, symbols) in [
        // On which coordinate, or along which way?
        (r"\dot V=0", "t: time; V(x): field"),
        (r"\frac{dV}{dt}=0", "t: time; V(x): field"),
        (r"\frac{dV}{dt}=0", "V(x,t): field"),
        // A parameter that a field's formula may name.
        (r"\frac{\partial S}{\partial b}=0", "S(q,t): field; b"),
        (r"\frac{\partial u}{\partial s}=0", "u(x): field; s: state"),
        // At the place, or of the value there?
        (r"\partial_xg(0,t)=0", r"g(x,t): field = \sin(x-t)"),
        (r"\frac{\partial g(0,t)}{\partial x}=0", r"g(x,t): field = \sin(x-t)"),
        (r"\nabla g(0,t)=0", r"g(x,t): field = \sin(x-t)"),
        (r"\frac{d}{dx}h(1)=0", "h(x): field = x^2"),
        // Indices: nothing that they could run over, once only, more than one sum, a sum inside.
        (r"\partial_iA_i=0", r"r: coordinate; \theta: coordinate = r; A(r,\theta): field, 2"),
        (r"\partial_iA_i=0", r"r, z: coordinate; A(r,z): field, 2"),
        (r"\partial_iA_i=0", r"x: coordinate; y: coordinate = x; A(x,y): field, 2"),
        (r"\partial_iA_i=0", r"A: 3"),
        (r"\partial_iu=0+u\partial_ju", "u(x,y): field"),
        (r"\partial_iA_i=0", "A(x,y): field, 3"),
        (r"\partial_i\partial_iA_iA_i=0", "A(x,y): field, 2"),
        (r"\partial_i(A_iA_i)=0", "A(x,y): field, 2"),
        (r"\partial_\mu A_\mu=0", "A(x,y): field, 2"),
        (r"\partial_su=0", "u(x,y): field"),
        // Places in places in places.
        (r"f(f(f(f(f(f(f(f(x))))))))=0", "f(x): field"),
        // Not Cartesian by its name.
        (r"\nabla^2f=f''", "f(r): field"),
    ] {
        let mut derivation = rederive::derivation::Derivation::blank();
        let typed: Vec<(String, String)> = symbols.split("; ").map(|s| (s.to_owned(), s.to_owned())).collect();
        derivation.declare_typed(&typed).unwrap_or_else(|e| panic!("{symbols}: {e:?}"));
        let proposition =
            rederive::check::Proposition { formula: text.to_owned(), given: Vec::new(), throughout: false };
        assert!(rederive::check::prove(&mut derivation, &proposition).is_err(), "{text} is read");
    }
}

#[test]
fn derivatives_by_what_a_formula_names() {
    let lagrangian = r"L = \frac12m\dot q^2-\frac12k q^2; q: state; m, k";
    all(&[
        (
            "proved",
            r"\frac{d}{dt}\frac{\partial L}{\partial\dot q}-\frac{\partial L}{\partial q}=m\ddot q+kq",
            lagrangian,
            "",
        ),
        ("refuted", r"\frac{d}{dt}\frac{\partial L}{\partial\dot q}=m\ddot q+kq", lagrangian, ""),
        ("proved", r"\dot q\frac{\partial L}{\partial\dot q}-L=\frac12m\dot q^2+\frac12kq^2", lagrangian, ""),
        ("proved", r"\frac{\partial^2L}{\partial\dot q^2}=m", lagrangian, ""),
        ("proved", r"\frac{\partial L}{\partial m}=\frac12\dot q^2", lagrangian, ""),
        ("proved", r"\frac{\partial L}{\partial t}=0", lagrangian, ""),
        // What observables stand for is written out first.
        ("proved", r"\frac{\partial}{\partial q}(E^2)=2kqE", r"E: observable = \frac12kq^2; q: state; k", ""),
        (
            "proved",
            r"\frac{d}{dt}H=0",
            r"H = \frac{p^2}{2m}+kq^4; q, p: state; m: positive; k",
            r"\dot q=\frac{\partial H}{\partial p}; \dot p=-\frac{\partial H}{\partial q}",
        ),
        (
            "refuted",
            r"\frac{d}{dt}H=0",
            r"H = \frac{p^2}{2m}+kq^4; q, p: state; m: positive; k",
            r"\dot q=\frac{\partial H}{\partial p}; \dot p=\frac{\partial H}{\partial q}",
        ),
    ]);
}

/// Orthogonal coordinates by their scale factors. The formulas of the right sides are those of textbooks (Jackson, Classical
/// Electrodynamics, inside of the back cover); the Cartesian rows above are the other route to the same theorems.
#[test]
fn orthogonal_coordinates() {
    let s = r"r: coordinate; \theta: coordinate = r; \varphi: coordinate = r\sin\theta; f(r,\theta,\varphi), g(r,\theta,\varphi): field; {\bf A}(r,\theta,\varphi): field, 3";
    let cylindrical = r"\rho: coordinate; \varphi: coordinate = \rho; z: coordinate; f(\rho,\varphi,z): field";
    // The catenoid: a surface with ds² = dσ² + (σ² + 1)dη².
    let catenoid = r"\sigma: coordinate; \eta: coordinate = \sqrt{\sigma^2+1}";
    all(&[
        (
            "proved",
            r"\nabla^2f=\frac{1}{r^2}\frac{\partial}{\partial r}\left(r^2\frac{\partial f}{\partial r}\right)+\frac{1}{r^2\sin\theta}\frac{\partial}{\partial\theta}\left(\sin(\theta)\frac{\partial f}{\partial\theta}\right)+\frac{1}{r^2\sin^2\theta}\frac{\partial^2f}{\partial\varphi^2}",
            s,
            "",
        ),
        (
            "proved",
            r"\nabla\cdot{\bf A}=\frac{1}{r^2}\frac{\partial(r^2{\bf A}_1)}{\partial r}+\frac{1}{r\sin\theta}\frac{\partial(\sin(\theta){\bf A}_2)}{\partial\theta}+\frac{1}{r\sin\theta}\frac{\partial {\bf A}_3}{\partial\varphi}",
            s,
            "",
        ),
        (
            "proved",
            r"(\nabla\times{\bf A})_1=\frac{1}{r\sin\theta}\left(\frac{\partial(\sin(\theta){\bf A}_3)}{\partial\theta}-\frac{\partial {\bf A}_2}{\partial\varphi}\right)",
            s,
            "",
        ),
        (
            "proved",
            r"(\nabla\times{\bf A})_3=\frac1r\left(\frac{\partial(r{\bf A}_2)}{\partial r}-\frac{\partial {\bf A}_1}{\partial\theta}\right)",
            s,
            "",
        ),
        ("proved", r"\nabla\times\nabla f=0", s, ""),
        ("proved", r"\nabla\cdot(\nabla\times{\bf A})=0", s, ""),
        ("proved", r"\nabla\cdot(f{\bf A})=f\nabla\cdot{\bf A}+{\bf A}\cdot(\nabla f)", s, ""),
        ("proved", r"\nabla^2(fg)=f\nabla^2g+g\nabla^2f+2(\nabla f)\cdot(\nabla g)", s, ""),
        ("proved", r"\nabla^2\frac1r=0", s, ""),
        ("proved", r"\nabla^2(r\cos\theta)=0", s, ""),
        ("proved", r"\nabla^2(r^2)=6", s, ""),
        ("proved", r"\nabla^2\left(r^2\sin^2\theta\cos2\varphi\right)=0", s, ""),
        ("refuted", r"\nabla^2(r^2)=2", s, ""),
        ("refuted", r"\nabla^2\frac{1}{r^2}=0", s, ""),
        (
            "refuted",
            r"\nabla\cdot{\bf A}=\partial_r{\bf A}_1+\partial_\theta{\bf A}_2+\partial_\varphi{\bf A}_3",
            s,
            "",
        ),
        ("proved", r"\nabla^2\ln\rho=0", cylindrical, ""),
        ("proved", r"\nabla\times(0,\rho,0)=(0,0,2)", cylindrical, ""),
        ("refuted", r"\nabla\times(0,\frac1\rho,0)=(0,0,1)", cylindrical, ""),
        ("proved", r"\nabla^2\operatorname{asinh}(\sigma)=0", catenoid, ""),
        ("proved", r"\nabla^2(\eta^2)=\frac{2}{\sigma^2+1}", catenoid, ""),
        ("refuted", r"\nabla^2(\eta^2)=2", catenoid, ""),
        (
            "proved",
            r"\nabla^2f=\frac1\rho\partial_\rho(\rho\partial_\rho f)+\frac{1}{\rho^2}\frac{\partial^2f}{\partial\varphi^2}+\frac{\partial^2f}{\partial z^2}",
            cylindrical,
            "",
        ),
    ]);
}

#[test]
fn unit_vectors_that_turn() {
    // U points along one axis everywhere.
    let ball = r"r: coordinate; \theta: coordinate = r; \varphi: coordinate = r\sin\theta; {\bf A}(r,\theta,\varphi), {\bf v}(r,\theta,\varphi): field, 3; {\bf U}(r,\theta,\varphi): field, 3 = (\cos\theta,-\sin\theta,0)";
    let tube = r"\rho: coordinate; \varphi: coordinate = \rho; z: coordinate; {\bf A}(\rho,\varphi,z), {\bf v}(\rho,\varphi,z): field, 3; {\bf W}(\rho,\varphi,z): field, 3 = (0,\rho,0); {\bf E}(\rho,\varphi,z): field, 3 = (\rho^2,0,0)";
    let flow = r"t: time; r: coordinate; \theta: coordinate = r; {\bf w}(r,\theta,t): field, 2, velocity";
    let lamb = r"({\bf A}\cdot\nabla){\bf A}=\nabla\left(\frac12{\bf A}^2\right)-{\bf A}\times(\nabla\times{\bf A})";
    all(&[
        ("proved", r"\nabla^2{\bf U}=0", ball, ""),
        ("proved", r"({\bf v}\cdot\nabla){\bf U}=0", ball, ""),
        ("refuted", r"\nabla^2U_1=0", ball, ""),
        ("proved", lamb, ball, ""),
        ("proved", lamb, tube, ""),
        ("proved", r"\nabla\cdot(\nabla^2{\bf A})=\nabla^2(\nabla\cdot{\bf A})", tube, ""),
        ("proved", r"(\nabla^2{\bf A})_3=\nabla^2A_3", tube, ""),
        (
            "proved",
            r"(\nabla^2{\bf A})_1=\nabla^2A_1-\frac{A_1}{\rho^2}-\frac{2}{\rho^2}\partial_\varphi A_2",
            tube,
            "",
        ),
        ("refuted", r"(\nabla^2{\bf A})_1=\nabla^2A_1", tube, ""),
        ("proved", r"(({\bf v}\cdot\nabla){\bf A})_1=({\bf v}\cdot\nabla)A_1-\frac{v_2A_2}{\rho}", tube, ""),
        ("refuted", r"(({\bf v}\cdot\nabla){\bf A})_1=({\bf v}\cdot\nabla)A_1", tube, ""),
        ("proved", r"({\bf W}\cdot\nabla){\bf W}=(-\rho,0,0)", tube, ""),
        ("refuted", r"({\bf W}\cdot\nabla){\bf W}=0", tube, ""),
        ("proved", r"(\nabla^2{\bf E})_1=3", tube, ""),
        ("refuted", r"(\nabla^2{\bf E})_1=4", tube, ""),
        (
            "proved",
            r"\left(\frac{D{\bf w}}{Dt}\right)_1=\partial_tw_1+w_1\partial_rw_1+\frac{w_2}{r}\partial_\theta w_1-\frac{w_2^2}{r}",
            flow,
            "",
        ),
    ]);
}

#[test]
fn coordinates_that_are_refused() {
    let refused = |symbols: &[&str]| {
        let texts: Vec<(String, String)> = symbols.iter().map(|s| (s.to_string(), s.to_string())).collect();
        let found = rederive::derivation::Derivation::blank().declare_typed(&texts).expect_err("it is refused");
        found[0].message.clone()
    };
    let rows: [(&[&str], &str); 5] = [
        (&["q: state", "s: coordinate = q"], "does not depend on `q`"),
        (&["t: coordinate = 2"], "no coordinate of space"),
        (&["s: coordinate, 3 = 2"], "one coordinate"),
        (&[r"\theta: coordinate = r", "r: coordinate"], "`r` is not declared"),
        // In which order unnamed ones come is not said, and the curl depends on it.
        (&[r"\varphi: coordinate = 2", r"f(\rho,\varphi,z): field"], "not declared as a coordinate"),
    ];
    for (symbols, message) in rows {
        let found = refused(symbols);
        assert!(found.contains(message), "{symbols:?}: {found}");
    }
}

#[test]
fn poisson_brackets() {
    let plane = r"q: state; p: state, momentum of q; m: positive; k; c";
    let fields = "p: coordinate, momentum of q; f(q,p), g(q,p), h(q,p): field; V(q): field";
    let space = r"{\bf q}: state, 3; {\bf p}: state, 3, momentum of {\bf q}; m, k: positive; {\bf L} = {\bf q}\times{\bf p}; r: observable = |{\bf q}|; H = \frac{{\bf p}^2}{2m}-\frac kr; {\bf A}: observable = {\bf p}\times({\bf q}\times{\bf p})-\frac{mk}{r}{\bf q}";
    let hamilton = r"q: state; p: state, momentum of q; m: positive; H = \frac{p^2}{2m}+q^4; G = q^2p\sin t";
    let equations = r"\dot q=\{q,H\}; \dot p=\{p,H\}";
    let action = r"\varphi; J: positive, momentum of \varphi; m, \omega: positive; q = \sqrt{\frac{2J}{m\omega}}\sin\varphi; p = \sqrt{2m\omega J}\cos\varphi";
    all(&[
        ("proved", r"\{q,p\}=1", plane, ""),
        ("refuted", r"\{p,q\}=1", plane, ""),
        ("proved", r"\left\{q^2,p^2\right\}=4qp", plane, ""),
        ("proved", r"\{q,p\}^2+2\{p,q\}=-1", plane, ""),
        ("proved", r"\frac{d}{dt}\{q^2,p\}=2\dot q", plane, ""),
        ("proved", r"\{q^2,p\}(0)=2q(0)", plane, ""),
        ("proved", r"\{kq,cp\}=kc", plane, ""),
        ("proved", r"\{|q|,p\}=1", plane, "q>0"),
        ("refuted", r"\{|q|,p\}=1", plane, ""),
        // A value at a point says nothing of slopes.
        ("unproved", r"\{q^2,p\}=0", plane, "q=1"),
        ("proved", r"\{q^2,p\}=2", plane, "q=1"),
        // What observables stand for.
        ("proved", r"\{E,p\}=kq", r"E: observable = \frac12kq^2; q: state; p: state, momentum of q; k", ""),
        ("refuted", r"\{E,p\}=0", r"E: observable = \frac12kq^2; q: state; p: state, momentum of q; k", ""),
        // The theorems, for any functions.
        ("proved", r"\{f,\{g,h\}\}+\{g,\{h,f\}\}+\{h,\{f,g\}\}=0", fields, ""),
        ("refuted", r"\{f,\{g,h\}\}=\{\{f,g\},h\}", fields, ""),
        ("proved", r"\{f,gh\}=\{f,g\}h+g\{f,h\}", fields, ""),
        ("proved", r"\{f,g\}=-\{g,f\}", fields, ""),
        ("refuted", r"\{f,g\}=0", fields, ""),
        ("proved", r"\{V,p\}=V'", fields, ""),
        ("proved", r"\{f,p\}=\frac{\partial f}{\partial q}", fields, ""),
        ("proved", r"\{f,g\}=0", fields, "g=f^2"),
        ("proved", r"\{f,p\}=1", fields, "f=q"),
        ("unproved", r"\{f,p\}=0", fields, "f=q; q=0"),
        ("unproved", r"\{f,g\}=0", fields, r"\{f,h\}=0"),
        // With components.
        ("proved", r"\{q_i,p_j\}=\delta_{ij}", space, ""),
        ("proved", r"\{q_i,p_i\}=3", space, ""),
        ("proved", r"\{L_i,L_j\}=\epsilon_{ijk}L_k", space, ""),
        ("refuted", r"\{L_i,L_j\}=-\epsilon_{ijk}L_k", space, ""),
        ("proved", r"\{{\bf L},H\}=0", space, ""),
        ("proved", r"\{{\bf A},H\}=0", space, ""),
        ("proved", r"\{A_i,L_j\}=\epsilon_{ijk}A_k", space, ""),
        ("proved", r"\{A_1,A_2\}=-2mHL_3", space, ""),
        ("refuted", r"\{A_1,A_2\}=2mHL_3", space, ""),
        // Along motions.
        ("proved", r"\dot G=\{G,H\}+\frac{\partial G}{\partial t}", hamilton, equations),
        ("unproved", r"\dot G=\{G,H\}", hamilton, equations),
        ("unproved", r"\dot G=\{H,G\}+\frac{\partial G}{\partial t}", hamilton, equations),
        // Canonical transformations.
        ("proved", r"\{q,p\}=1", action, ""),
        ("refuted", r"\{q,p\}=2", action, ""),
        ("proved", r"\{q^2,\frac{p}{2q}\}=1", plane, ""),
        ("refuted", r"\{q^2,\frac pq\}=1", plane, ""),
        (
            "proved",
            r"\{a,a^*\}=-\mathrm i",
            r"a: complex = \frac{q+\mathrm ip}{\sqrt2}; q: state; p: state, momentum of q",
            "",
        ),
        // ∇ acts on places, not on momenta.
        ("proved", r"\nabla^2f=\frac{\partial^2f}{\partial q^2}", fields, ""),
    ]);
}

#[test]
fn variational_derivatives() {
    let spring = r"L = \frac12m\dot q^2-\frac12kq^2; q: state; m: positive; k";
    let wave = r"L = \frac12(\partial_tu)^2-\frac12(c\partial_xu)^2; u(x,t): field; c";
    let quantum = r"\psi(x,t): field, complex; V(x): field; h, m: positive; L = \operatorname{Re}(\mathrm ih\psi^*\partial_t\psi)-\frac{h^2}{2m}|\partial_x\psi|^2-V|\psi|^2";
    all(&[
        ("proved", r"\frac{\delta L}{\delta q}=-m\ddot q-kq", spring, ""),
        ("refuted", r"\frac{\delta L}{\delta q}=-kq", spring, ""),
        ("refuted", r"\frac{\delta L}{\delta q}=m\ddot q-kq", spring, ""),
        (
            "proved",
            r"\frac{\delta L}{\delta q}=\frac{\partial L}{\partial q}-\frac{d}{dt}\frac{\partial L}{\partial\dot q}",
            spring,
            "",
        ),
        (
            "proved",
            r"\frac{d}{dt}\left(\dot q\frac{\partial L}{\partial\dot q}-L\right)=0",
            spring,
            r"\frac{\delta L}{\delta q}=0",
        ),
        ("proved", r"\frac{\delta L}{\delta q}=\frac{d^4q}{dt^4}", r"L = \frac12\ddot q^2; q: state", ""),
        ("proved", r"\frac{\delta L}{\delta q}=-1", r"L = t\dot q; q: state", ""),
        // A total derivative.
        ("proved", r"\frac{\delta L}{\delta q}=0", r"L = q^2\dot q\sin t+\frac13q^3\cos t; q: state", ""),
        ("proved", r"\frac{\delta E}{\delta q}=q", r"E: observable = \frac12q^2; q: state", ""),
        ("refuted", r"\frac{\delta L}{\delta q}=1", r"L = |q|; q: state", ""),
        ("proved", r"\frac{\delta L}{\delta q}=1", r"L = |q|; q: state", "q>0"),
        (
            "proved",
            r"\frac{\delta L}{\delta{\bf q}}=-m\ddot{\bf q}",
            r"L = \frac12m\dot{\bf q}^2; {\bf q}: state, 3; m",
            "",
        ),
        ("proved", r"\frac{\delta L}{\delta q_2}=-m\ddot q_2", r"L = \frac12m\dot{\bf q}^2; {\bf q}: state, 3; m", ""),
        // A Kronecker symbol, as before.
        ("proved", r"\frac{\delta_{11}}{2}=\frac12", "x", ""),
        // Fields.
        ("proved", r"\frac{\delta L}{\delta u}=c^2\partial_x^2u-\partial_t^2u", wave, ""),
        ("refuted", r"\frac{\delta L}{\delta u}=c^2\partial_x^2u+\partial_t^2u", wave, ""),
        (
            "proved",
            r"\frac{\partial}{\partial t}\left(\frac12(\partial_tu)^2+\frac12(c\partial_xu)^2\right)=c^2\frac{\partial}{\partial x}(\partial_xu\,\partial_tu)",
            wave,
            r"\frac{\delta L}{\delta u}=0",
        ),
        (
            "proved",
            r"\frac{\delta H}{\delta u}=3u^2+\partial_x^2u",
            r"H = u^3-\frac12(\partial_xu)^2; u(x,t): field",
            "",
        ),
        ("proved", r"\frac{\delta H}{\delta u}=\partial_x^4u", r"H = \frac12(\partial_x^2u)^2; u(x,t): field", ""),
        (
            "proved",
            r"\frac{\delta H}{\delta u}=0",
            r"H = \partial_xu\,\partial_t^2u+\partial_tu\,\partial_t\partial_xu; u(x,t): field",
            "",
        ),
        (
            "proved",
            r"\frac{\delta\ell}{\delta y}=-\frac{y''}{(1+(y')^2)^{3/2}}",
            r"\ell = \sqrt{1+(y')^2}; y(x): field",
            "",
        ),
        (
            "proved",
            r"\frac{\delta L}{\delta\psi^*}=\mathrm ih\partial_t\psi+\frac{h^2}{2m}\partial_x^2\psi-V\psi",
            quantum,
            "",
        ),
        (
            "refuted",
            r"\frac{\delta L}{\delta\psi}=\mathrm ih\partial_t\psi+\frac{h^2}{2m}\partial_x^2\psi-V\psi",
            quantum,
            "",
        ),
        (
            "proved",
            r"\frac{\delta L}{\delta\psi}=-\mathrm ih\partial_t\psi^*+\frac{h^2}{2m}\partial_x^2\psi^*-V\psi^*",
            quantum,
            "",
        ),
    ]);
}

#[test]
fn following_a_flow() {
    let plane = r"{\bf v}(x,y,t): field, 2, velocity; f(x,y,t), g(x,y,t), \rho(x,y,t): field";
    all(&[
        ("proved", r"\frac{Df}{Dt}=\frac{\partial f}{\partial t}+({\bf v}\cdot\nabla)f", plane, ""),
        ("refuted", r"\frac{Df}{Dt}=\frac{\partial f}{\partial t}", plane, ""),
        ("proved", r"\frac{D}{Dt}(fg)=f\frac{Dg}{Dt}+g\frac{Df}{Dt}", plane, ""),
        ("proved", r"\frac{D{\bf v}}{Dt}=\frac{\partial{\bf v}}{\partial t}+({\bf v}\cdot\nabla){\bf v}", plane, ""),
        ("proved", r"\frac{Dx}{Dt}=v_1", plane, ""),
        ("proved", r"\frac{Dt}{Dt}=1", plane, ""),
        ("proved", r"\frac{D\rho}{Dt}+\rho\nabla\cdot{\bf v}=0", plane, r"\partial_t\rho+\nabla\cdot(\rho{\bf v})=0"),
        ("refuted", r"\frac{D\rho}{Dt}=0", plane, r"\partial_t\rho+\nabla\cdot(\rho{\bf v})=0"),
        ("proved", r"\frac{Du}{Dt}=\partial_tu+u\partial_xu", "u(x,t): field, velocity", ""),
        ("proved", r"\frac{D}{Dt}(x-ct)=-c", "u(x,t): field, velocity = 0; c", ""),
        // Unit vectors that do not turn what is a number.
        (
            "proved",
            r"\frac{Df}{Dt}=\partial_tf+w_1\partial_rf+\frac{w_2}{r}\partial_\theta f",
            r"t: time; r: coordinate; \theta: coordinate = r; {\bf w}(r,\theta,t): field, 2, velocity; f(r,\theta,t): field",
            "",
        ),
    ]);
}

#[test]
fn what_mechanics_does_not_say_is_refused() {
    let pair = "q: state; p: state, momentum of q";
    for (text, symbols) in [
        // No canonical variables, or not enough.
        (r"\{q,p\}=1", "q, p: state"),
        (r"\{q,s\}=0", "q: state; p: state, momentum of q; s: state"),
        (r"\{c,q\}=0", "q: state; p: state, momentum of q; c"),
        (r"\{q,\dot q\}=0", pair),
        (r"\{q(0),p\}=0", pair),
        (r"\{E(0),p\}=0", "q: state; p: state, momentum of q; E: observable = q^2"),
        (r"\{\dot E,p\}=0", "q: state; p: state, momentum of q; E: observable = q^2"),
        (r"\{V,p\}=0", "q: state; p: state, momentum of q; V(x): field"),
        // A set, a group, two vectors.
        (r"q=\{0,1\}", pair),
        (r"\{q,p,q\}=0", pair),
        (r"\{q,p\}_q=1", pair),
        (r"\{{\bf q},{\bf p}\}=0", r"{\bf q}: state, 3; {\bf p}: state, 3, momentum of {\bf q}"),
        // What is put in the place of an argument depends on the variables.
        (r"f(q)=0", r"q: state; p: state, momentum of q; f(a) = \{a^2,p\}"),
        (r"f(q)=0", r"q: state; f(a) = \frac{\partial(a^2)}{\partial q}"),
        (r"f(q)=0", r"q: state; f(a) = \frac{d}{dt}(a^2)"),
        (r"f(x)=0", r"x: coordinate; f(a) = \partial_x(a^2)"),
        (r"f(q)=0", r"q: state; f(a) = \frac{\delta(a^2)}{\delta q}"),
        // Along the motion, or by the time alone?
        (r"\dot f=0", "p: coordinate, momentum of q; f(q,p,t): field"),
        // No pairs.
        (r"p=0", "q: state; p: momentum of q"),
        (r"p=0", "q: state; p: state, 3, momentum of q"),
        (r"p=0", "q: state, 2x3; p: state, 3x2, momentum of q"),
        (r"p=0", "q, s: state; p: state, momentum of q; P: state, momentum of q"),
        (r"p=0", "q: state; p: state, momentum of q; s: state, momentum of p"),
        (r"p=0", "p: state, momentum of p"),
        (r"p=0", "p: state, momentum of s"),
        // Which flow, of what shape, and which sign of the time?
        (r"\frac{Df}{Dt}=0", "f(x,t): field"),
        (r"\frac{Df}{Dt}=0", r"f(x,y,t): field; {\bf v}(x,y,t): field, 3, velocity"),
        (
            r"\frac{Df}{Dt}=0",
            r"f(x,y,t): field; {\bf v}(x,y,t): field, 2, velocity; {\bf w}(x,y,t): field, 2, velocity",
        ),
        (r"\frac{Df}{Dt}=\frac ft", "f(x,t), v(x,t): field; w(x,t): field, velocity; D"),
        (r"\frac{Df}{Dx}=0", "f(x,t), v(x,t): field; w(x,t): field, velocity"),
        (r"\frac{Dq}{Dt}=0", "v(x,t): field, velocity; q: state"),
        (r"f(x)=0", r"v(x,t): field, velocity; f(a) = \frac{D(a^2)}{Dt}"),
        (r"\Box u=0", "u(x,t): field; c"),
        // Over what is it integrated, and what is varied?
        (r"\frac{\delta L}{\delta u}=0", "L = tu^2; u(x): field; t: coordinate"),
        (r"\frac{\delta L}{\delta u}=0", "L = vu^2; u(x), v(x,y): field"),
        (r"\frac{\delta L}{\delta u}=0", "L = qu^2; u(x,t): field; q: state"),
        (r"\frac{\delta L}{\delta q}=0", "L = uq^2; u(x,t): field; q: state"),
        (r"\frac{\delta L}{\delta q}=0", "L = xq^2; x: coordinate; q: state"),
        (r"\frac{\delta L}{\delta q}=0", r"L = q(0)^2; q: state"),
        (r"\frac{\delta L}{\delta m}=0", r"L = m\dot q^2; q: state; m"),
        (r"\frac{\delta L}{\delta Q}=q", r"L = \frac12q^2; Q = -q; q: state"),
        (r"\frac{\delta L}{\delta\dot q}=0", r"L = \dot q^2; q: state"),
        (r"\frac{\delta S}{\delta q}=0", "q: state; S"),
        (r"\frac{\delta^2L}{\delta q^2}=0", "L = q^2; q: state"),
        (r"\frac{\delta L}{\delta u}=0", r"r: coordinate; \theta: coordinate = r; u(r,\theta): field; L = u^2"),
    ] {
        let mut derivation = rederive::derivation::Derivation::blank();
        let typed: Vec<(String, String)> = symbols.split("; ").map(|s| (s.to_owned(), s.to_owned())).collect();
        if derivation.declare_typed(&typed).is_err() {
            continue;
        }
        let proposition =
            rederive::check::Proposition { formula: text.to_owned(), given: Vec::new(), throughout: false };
        assert!(rederive::check::prove(&mut derivation, &proposition).is_err(), "{text}, {symbols}: it is read");
    }
}
