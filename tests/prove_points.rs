//! True steps of which a real point has to be found, exponents that agree once they are in normal form, products of powers; and
//! beside each what is nearly so, and false. The rows are those of `prove_traps`.

use crate::prove_traps::{Row, all};

#[test]
fn a_point_is_found_where_there_is_one() {
    let angle = r"a\cos2b=c\sin2b";
    all(&[
        // Solutions of transcendental equations: 0 is one, and another lies between 2 and 3.
        ("proved", r"xe^x=3(e^x-1)", "x", r"x=3(1-e^{-x})"),
        ("proved", r"3-x=3e^{-x}", "x: positive", r"x=3(1-e^{-x})"),
        ("refuted", r"3-x=2e^{-x}", "x: positive", r"x=3(1-e^{-x})"),
        ("unproved", r"3-x=3e^{-x}", "x: positive", r"x=-3(1-e^{-x})"),
        ("unproved", r"3-x=3e^{-x}", "x", r"x=3(1-e^{-x}); x>4"),
        ("proved", angle, "a,c: positive; b", r"\tan2b=\frac ac"),
        ("refuted", angle, "a,c: positive; b", r"\tan2b=\frac ca"),
        ("proved", r"pa^c=qb^c", "p,q,a,b,c: positive", r"paa^{c-1}=qbb^{c-1}"),
        // Where everything is 1.
        ("proved", r"pV^g=qW^g", "p,q,V,W,g,T,S,R: positive", r"pV=RT; qW=RS; TV^{g-1}=SW^{g-1}"),
        ("refuted", r"pV^g=qW^g", "p,q,V,W,g,T,S,R: positive", r"pV=RT; qW=RS; TV^{g-1}=SW^{g+1}"),
        // Beyond the numbers that are tried first.
        ("proved", r"\sqrt{(x-5)^2}=x-5", "x", r"x>1000"),
        ("refuted", r"\sqrt{(x-1001)^2}=x-1001", "x", r"x>1000"),
        ("proved", r"|x-2|=3-|x-5|", "x", r"x>\frac{21}{10}; x<\frac{22}{10}"),
        // False near a bound only.
        ("refuted", r"\arcsin(\sin x)=x", "x", r"x>-2; x<2"),
        ("proved", r"\arcsin(\sin x)=x", "x", r"x>-1; x<1"),
        // No point satisfies what is given.
        ("undecided", r"x=7", "x", r"x>5; x<5"),
        ("unproved", r"y=1", "x,y", r"x^2+1=0; xy=x"),
    ]);
}

#[test]
fn exponents_are_compared_in_normal_form() {
    let z = r"s: positive; t,x; G: complex = e^{-\frac{x^2}{4(s+\mathrm it)}}";
    let mut rows: Vec<Row> = vec![
        ("proved", r"(e^{\frac{x}{4(s+1)}})^2=e^{\frac{x}{2s+2}}", "s,x", ""),
        ("refuted", r"(e^{\frac{x}{4(s+1)}})^2=e^{\frac{x}{2s+1}}", "s,x", ""),
        ("proved", r"e^{\frac x{s+1}-\frac x{s+2}}=e^{\frac x{(s+1)(s+2)}}", "s,x", ""),
        ("refuted", r"e^{\frac x{s+1}+\frac x{s+2}}=e^{\frac x{(s+1)(s+2)}}", "s,x", ""),
        ("proved", r"e^{\frac{s^2}{s+1}}e^{\frac s{1+s}}=e^s", "s", ""),
        ("proved", r"\sin\frac{2x}{s+1}=2\sin\frac{3x}{3s+3}\cos\frac x{1+s}", "s,x", ""),
        ("refuted", r"\sin\frac{2x}{s+1}=2\sin\frac{3x}{3s+1}\cos\frac x{1+s}", "s,x", ""),
        ("proved", r"(e^{\frac{xs}{s^2+\frac{t^2}{m^2}}})^2=e^{\frac{2m^2xs}{m^2s^2+t^2}}", "s,m,t,x", ""),
        ("refuted", r"(e^{\frac{xs}{s^2+\frac{t^2}{m^2}}})^2=e^{\frac{2m^2xs}{m^2s^2-t^2}}", "s,m,t,x", ""),
        ("proved", r"e^{\frac1{\frac1a+\frac1b}}=e^{\frac{ab}{a+b}}", "a,b", ""),
    ];
    rows.push(("proved", r"|G|^2=e^{-\frac{x^2s}{2(s^2+t^2)}}", z, ""));
    rows.push(("refuted", r"|G|^2=e^{-\frac{x^2s}{s^2+t^2}}", z, ""));
    all(&rows);
}

#[test]
fn logarithms_of_sums_of_exponentials_have_coefficients_that_are_functions() {
    let n = r"x; n=\frac1{e^x+1}";
    all(&[
        ("proved", r"-n\ln n-(1-n)\ln(1-n)=xn+\ln(1+e^{-x})", n, ""),
        ("unproved", r"-n\ln n-(1-n)\ln(1-n)=xn+\ln(1+e^x)", n, ""),
        ("unproved", r"-n\ln n+(1-n)\ln(1-n)=xn+\ln(1+e^{-x})", n, ""),
    ]);
}

#[test]
fn products_of_powers_are_linear_in_logarithms() {
    let symbols = r"T,S,V_1,V_2,V_3,V_4: positive; g: positive";
    let cycle = r"TV_2^{g-1}=SV_3^{g-1}; TV_1^{g-1}=SV_4^{g-1}; g>1";
    all(&[
        ("proved", r"\frac{V_2}{V_1}=\frac{V_3}{V_4}", symbols, cycle),
        ("refuted", r"\frac{V_2}{V_1}=\frac{V_4}{V_3}", symbols, cycle),
        // g = 1 leaves the volumes free.
        ("unproved", r"\frac{V_2}{V_1}=\frac{V_3}{V_4}", symbols, r"TV_2^{g-1}=SV_3^{g-1}; TV_1^{g-1}=SV_4^{g-1}"),
        ("proved", r"V=W", "V,W,g: positive", r"V^g=W^g"),
        ("proved", r"V=W", "V,W,g: positive", r"V^{g-1}=W^{g-1}; g>1"),
        ("refuted", r"V=W", "V,W,g: positive", r"V^{g-1}=W^{g-1}"),
        ("refuted", r"V=2W", "V,W,g: positive", r"V^{g-1}=W^{g-1}; g>1"),
        // Of what need not be positive there is no logarithm.
        ("unproved", r"V=W", "V,W; g: positive", r"V^{2}W^g=W^{2}W^g"),
    ]);
}

#[test]
fn equal_values_of_functions_that_are_one_to_one_are_of_equal_arguments() {
    all(&[
        ("proved", r"x=y", "x,y", r"e^x=e^y"),
        ("proved", r"x=y", "x,y", r"\sinh x=\sinh y"),
        ("proved", r"x=y", "x,y", r"\tanh x=\tanh y"),
        ("refuted", r"x=y", "x,y", r"\cosh x=\cosh y"),
        ("refuted", r"x=-y", "x,y", r"e^x=e^y"),
        ("unproved", r"x=y", "x,y", r"\sin x=\sin y"),
    ]);
}

#[test]
fn what_is_not_negative_is_equal_where_its_squares_are() {
    let gamma = r"c: positive; u,v,w";
    let sum = r"|u|<c; |v|<c; w=\frac{u+v}{1+uv/c^2}";
    let packet = r"s: positive; t; G: complex = \frac1{\sqrt{s+\mathrm it}}";
    all(&[
        (
            "proved",
            r"\frac1{\sqrt{1-w^2/c^2}}=\frac1{\sqrt{1-u^2/c^2}}\frac1{\sqrt{1-v^2/c^2}}\left(1+\frac{uv}{c^2}\right)",
            gamma,
            sum,
        ),
        (
            "refuted",
            r"\frac1{\sqrt{1-w^2/c^2}}=\frac1{\sqrt{1-u^2/c^2}}\frac1{\sqrt{1-v^2/c^2}}\left(1-\frac{uv}{c^2}\right)",
            gamma,
            sum,
        ),
        // uv/c² may be below −1.
        ("unproved", r"\left|1+\frac{uv}{c^2}\right|=1+\frac{uv}{c^2}", gamma, r"|u|<c; |v|<2c"),
        ("proved", r"|G|=(s^2+t^2)^{-1/4}", packet, ""),
        ("refuted", r"|G|=(s^2+t^2)^{1/4}", packet, ""),
        ("refuted", r"\sqrt{x^2+y^2}=x+y", "x,y: positive", ""),
        ("refuted", r"\sqrt{x^2}=x", "x", ""),
        ("refuted", r"\sqrt{x^2y^2}=xy", "x,y", r"|x|<1; |y|<1"),
    ]);
}
