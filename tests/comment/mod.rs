//! The Comment's identities and derivation steps, written out in components.
//!
//! Names: R11 … R33 the rotation, w1 … w3 the angular velocity Ω, I1 … I3 the moments, th, ph, ps the Euler angles,
//! a prime for a time derivative.

#![allow(dead_code, reason = "each test binary uses a part")]

/// One step: what is concluded, from what.
pub struct Step {
    pub id: &'static str,
    pub claim: String,
    pub premises: String,
    pub moving: String,
}

const POSITIVE: &str = "I1 > 0; I2 > 0; I3 > 0";

fn next(i: usize) -> usize {
    i % 3 + 1
}

/// Entry of R = Rz(φ) Rx(θ) Rz(ψ).
pub fn euler(i: usize, j: usize) -> &'static str {
    [
        ["cos(ph)*cos(ps) - sin(ph)*cos(th)*sin(ps)", "-cos(ph)*sin(ps) - sin(ph)*cos(th)*cos(ps)", "sin(ph)*sin(th)"],
        ["sin(ph)*cos(ps) + cos(ph)*cos(th)*sin(ps)", "-sin(ph)*sin(ps) + cos(ph)*cos(th)*cos(ps)", "-cos(ph)*sin(th)"],
        ["sin(th)*sin(ps)", "sin(th)*cos(ps)", "cos(th)"],
    ][i - 1][j - 1]
}

fn over_entries(f: impl Fn(usize, usize) -> String) -> String {
    let mut all = Vec::new();
    for i in 1..=3 {
        for j in 1..=3 {
            all.push(f(i, j));
        }
    }
    all.join("; ")
}

fn over(f: impl Fn(usize) -> String) -> String {
    (1..=3).map(f).collect::<Vec<_>>().join("; ")
}

/// Ṙ_ij = −ε_jkp W_k R_ip for a velocity given by expressions.
pub fn poisson(r: &str, w: impl Fn(usize) -> String) -> String {
    over_entries(|i, j| {
        let (k, l) = (next(j), next(next(j)));
        format!("{r}{i}{j}' = {r}{i}{k}*({}) - {r}{i}{l}*({})", w(l), w(k))
    })
}

pub fn euler_equations() -> String {
    over(|i| {
        let (j, k) = (next(i), next(next(i)));
        format!("I{i}*w{i}' = (I{j} - I{k})*w{j}*w{k}")
    })
}

pub fn orthogonal(r: &str) -> String {
    let mut all = Vec::new();
    for j in 1..=3 {
        for k in j..=3 {
            let sum = (1..=3).map(|i| format!("{r}{i}{j}*{r}{i}{k}")).collect::<Vec<_>>().join(" + ");
            all.push(format!("{sum} = {}", usize::from(j == k)));
        }
    }
    all.join("; ")
}

pub fn determinant(r: &str) -> String {
    format!(
        "{r}11*({r}22*{r}33 - {r}23*{r}32) - {r}12*({r}21*{r}33 - {r}23*{r}31) + {r}13*({r}21*{r}32 - {r}22*{r}31) = 1"
    )
}

/// m_i = R_ij I_j Ω_j.
pub fn momentum() -> String {
    over(|i| format!("m{i} = R{i}1*I1*w1 + R{i}2*I2*w2 + R{i}3*I3*w3"))
}

pub fn energy() -> &'static str {
    "E = (I1*w1^2 + I2*w2^2 + I3*w3^2)/2"
}

/// t7.1.
pub fn t71() -> String {
    poisson("R", |k| format!("m3*R3{k}/I{k}"))
}

pub fn euler_angles() -> String {
    over_entries(|i, j| format!("R{i}{j} = {}", euler(i, j)))
}

pub const T9A: &str = "th' = m3*(1/I1 - 1/I2)*sin(th)*sin(ps)*cos(ps)";
pub const T9B: &str = "ph' = m3/I1*sin(ps)^2 + m3/I2*cos(ps)^2";
pub const T9C: &str = "ps' = -(m3/I1*sin(ps)^2 + m3/I2*cos(ps)^2)*cos(th) + m3/I3*cos(th)";
pub const T10: &str = "2*E = m3^2/I3 + m3^2*((1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2)*sin(th)^2";
/// t11 squared: (dψ/dφ)² with dψ/dφ = ψ̇/φ̇.
pub const T11: &str = "(ps'/ph')^2 = ((1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2)\
    *(1/I3 - 2*E/m3^2 + (1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2)/(1/I1 - (1/I1 - 1/I2)*cos(ps)^2)^2";
/// The sign rule: dψ/dφ has the sign of −A cos θ.
pub const T11_SIGN: &str = "ps'/ph' = -abs(A*cos(th))/(A*cos(th))\
    *sqrt(A*(1/I3 - 2*E/m3^2 + A))/(1/I1 - (1/I1 - 1/I2)*cos(ps)^2); \
    A = (1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2";
pub const PSI0: &str = "cos(ps)^2 = I2*(I3 - I1)/(I3*(I2 - I1))";

pub fn steps() -> Vec<Step> {
    let step = |id, claim: String, premises: String, moving: &str| Step {
        id,
        claim,
        premises: format!("{premises}; {POSITIVE}"),
        moving: moving.to_owned(),
    };
    let rw = "R11 R12 R13 R21 R22 R23 R31 R32 R33 w1 w2 w3 m1 m2 m3 E";
    let rotation = "R11 R12 R13 R21 R22 R23 R31 R32 R33";
    let angles = "R11 R12 R13 R21 R22 R23 R31 R32 R33 th ph ps";
    let t1 = format!("{}; {}", poisson("R", |k| format!("w{k}")), euler_equations());
    let kinematics = format!("{}; {}", t71(), euler_angles());
    let omega_of_m = |k: usize| format!("(m1*R1{k} + m2*R2{k} + m3*R3{k})/I{k}");
    let t8 = "R11 = cos(m3/I3*t); R12 = -sin(m3/I3*t); R13 = 0; R21 = sin(m3/I3*t); R22 = cos(m3/I3*t); R23 = 0; \
              R31 = 0; R32 = 0; R33 = 1";
    let t9 = format!("{T9A}; {T9B}; {T9C}");
    let k = "k = m3*(1/I1 - 1/I2)*sin(2*ps)/2";
    let t15 = "cos(th) = (1 - c*exp(2*k*t))/(1 + c*exp(2*k*t)); sin(th) = 2*sqrt(c)*exp(k*t)/(1 + c*exp(2*k*t)); \
               ph = m3/I3*t + ph0; c > 0";
    vec![
        step("E conserved", "E' = 0".into(), format!("{}; {t1}", energy()), rw),
        step("m conserved", "m1' = 0; m2' = 0; m3' = 0".into(), format!("{}; {t1}", momentum()), rw),
        step(
            "Euler from m conserved",
            euler_equations(),
            format!(
                "{}; {}; m1' = 0; m2' = 0; m3' = 0; {}; {}",
                poisson("R", |k| format!("w{k}")),
                momentum(),
                orthogonal("R"),
                determinant("R")
            ),
            rw,
        ),
        step(
            "omega of m",
            over(|k| format!("w{k} = {}", omega_of_m(k))),
            format!("{}; {}; {}", momentum(), orthogonal("R"), determinant("R")),
            "",
        ),
        step(
            "t3",
            poisson("R", omega_of_m),
            format!("{}; {}; {}; {}", poisson("R", |k| format!("w{k}")), momentum(), orthogonal("R"), determinant("R")),
            "",
        ),
        step("t7.1", t71(), format!("{}; m1 = 0; m2 = 0", poisson("R", omega_of_m)), ""),
        step("t8 solves t7.1", t71(), t8.into(), rotation),
        step("t9 from t7.1", t9.clone(), format!("{kinematics}; sin(th) != 0"), angles),
        step("t7.1 from t9", t71(), format!("{t9}; {}", euler_angles()), angles),
        step(
            "t10",
            T10.into(),
            format!("{}; {}; {}", energy(), over(|k| format!("w{k} = m3*R3{k}/I{k}")), euler_angles()),
            "",
        ),
        step("t11 squared", T11.into(), format!("{t9}; {T10}; m3 != 0"), ""),
        step(
            "t11 sign",
            T11_SIGN.split(';').next().unwrap_or_default().to_owned(),
            format!("{t9}; {T10}; m3 != 0; {}", T11_SIGN.split_once(';').map_or("", |(_, a)| a)),
            "",
        ),
        step(
            "Eq. (1) of the Letter",
            "(1/I3 - 2*E/m3^2 + (1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2)*m3^2*I1*I2 \
             = m3^2*(I2*sin(ps)^2 + I1*cos(ps)^2) - 2*E*I1*I2"
                .into(),
            "m3 != 0".into(),
            "",
        ),
        step(
            "E-m relation in t10",
            "((1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2)*sin(th)^2 = 0".into(),
            format!("{T10}; 2*E = m3^2/I3; m3 != 0"),
            "",
        ),
        step(
            "psi0",
            PSI0.into(),
            "((1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2)*sin(th)^2 = 0; sin(th) != 0; I1 - I2 != 0".into(),
            "",
        ),
        step(
            "psi0 solves t9c",
            "0 = -(m3/I1*sin(ps)^2 + m3/I2*cos(ps)^2)*cos(th) + m3/I3*cos(th)".into(),
            format!("{PSI0}; I1 - I2 != 0"),
            "",
        ),
        step(
            "psi0 solves t11",
            "0 = ((1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2)*(1/I3 - 2*E/m3^2 + (1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2)"
                .into(),
            format!("{PSI0}; I1 - I2 != 0"),
            "",
        ),
        step(
            "reduced equations",
            "th' = m3*(1/I1 - 1/I2)*sin(2*ps)*sin(th)/2; ph' = m3/I3".into(),
            format!("{PSI0}; {T9A}; {T9B}; I1 - I2 != 0"),
            "",
        ),
        step(
            "t15 solves t9",
            "th' = m3*(1/I1 - 1/I2)*sin(th)*sin(ps)*cos(ps); ph' = m3/I1*sin(ps)^2 + m3/I2*cos(ps)^2; \
             0 = -(m3/I1*sin(ps)^2 + m3/I2*cos(ps)^2)*cos(th) + m3/I3*cos(th)"
                .into(),
            format!("{t15}; {k}; {PSI0}; I1 - I2 != 0"),
            "th ph",
        ),
        step(
            "k squared",
            "k^2 = m3^2*(I1 - I3)*(I3 - I2)/(I1*I2*I3^2)".into(),
            format!("{k}; {PSI0}; I1 - I2 != 0"),
            "",
        ),
        step(
            "R' = A R solves t7.1",
            poisson("S", |k| format!("n*S3{k}/I{k}")),
            format!(
                "{}; {}; {}",
                poisson("R", omega_of_m),
                over_entries(|i, j| format!("S{i}{j} = A{i}1*R1{j} + A{i}2*R2{j} + A{i}3*R3{j}")),
                "m1 = n*A31; m2 = n*A32; m3 = n*A33"
            ),
            "R11 R12 R13 R21 R22 R23 R31 R32 R33 S11 S12 S13 S21 S22 S23 S31 S32 S33",
        ),
        step(
            "S = R(0)^T R solves t3 with m_S",
            poisson("S", |k| format!("(n1*S1{k} + n2*S2{k} + n3*S3{k})/I{k}")),
            format!(
                "{}; {}; {}; {}; {}",
                poisson("R", omega_of_m),
                over_entries(|i, j| format!("S{i}{j} = Q1{i}*R1{j} + Q2{i}*R2{j} + Q3{i}*R3{j}")),
                over(|i| format!("n{i} = Q1{i}*m1 + Q2{i}*m2 + Q3{i}*m3")),
                orthogonal("Q"),
                determinant("Q")
            ),
            "R11 R12 R13 R21 R22 R23 R31 R32 R33 S11 S12 S13 S21 S22 S23 S31 S32 S33",
        ),
        step(
            "S obeys the E-m relation",
            "2*E = n1^2/I1 + n2^2/I2 + n3^2/I3".into(),
            format!(
                "{}; {}; {}; {}; {}",
                // At t = 0: Ω = I⁻¹ R(0)ᵀ m, so n = R(0)ᵀ m = I Ω(0).
                over(|i| format!("n{i} = Q1{i}*m1 + Q2{i}*m2 + Q3{i}*m3")),
                over(|k| format!("w{k} = (m1*Q1{k} + m2*Q2{k} + m3*Q3{k})/I{k}")),
                energy(),
                orthogonal("Q"),
                determinant("Q")
            ),
            "",
        ),
    ]
}
