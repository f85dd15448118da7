use num_dual::{Dual, Dual2};
use rederive::number::*;
#[test]
fn smoke() {
    for &op in Op::ALL {
        for (a, b) in [(0.3, 0.7), (0.9, 0.2), (0.05, 0.99), (0.5, 0.25)] {
            let cx = Orders::all(6);
            let (ja, jb) = (Jet::variable(a, 1.25, &cx), Jet::variable(b, -0.5, &cx));
            let mut j = Jet::blank(&cx);
            let r = op.apply(&cx, &mut j, &ja, &jb);
            let mut s = Jet::blank(&cx);
            let mut r2 = Ok(());
            for k in 0..=6 {
                let c = Orders::only(k, 6);
                let mut pa = Jet::blank(&cx);
                for i in 0..=k {
                    pa.set_coefficient(i, ja.coefficient(i));
                }
                let mut pb = Jet::blank(&cx);
                for i in 0..=k {
                    pb.set_coefficient(i, jb.coefficient(i));
                }
                r2 = r2.and(op.apply(&c, &mut s, &pa, &pb));
            }
            assert_eq!(r, r2);
            let mut d = Dual::new(0., 0.);
            let rd = op.apply(&(), &mut d, &Dual::new(a, 1.25), &Dual::new(b, -0.5));
            let mut e = Dual2::new(0., 0., 0.);
            let re = op.apply(&(), &mut e, &Dual2::new(a, 1.25, 0.), &Dual2::new(b, -0.5, 0.));
            assert_eq!(r, rd);
            assert_eq!(r, re);
            if r.is_err() {
                println!("{op:?} {r:?}");
                continue;
            }
            for k in 0..=6 {
                assert_eq!(j.coefficient(k).to_bits(), s.coefficient(k).to_bits(), "{op:?} {k}");
            }
            let close = |x: f64, y: f64| (x - y).abs() <= 1e-13 * (1.0 + x.abs());
            assert!(
                close(j.coefficient(1), d.eps) && close(e.v1, d.eps) && close(2. * j.coefficient(2), e.v2),
                "{op:?} {j:?} {d:?} {e:?}"
            );
            // finite differences of the polynomial at h
            let h = 0.001;
            let mut v = 0.0;
            op.apply(&(), &mut v, &(a + 1.25 * h), &(b - 0.5 * h)).unwrap();
            assert!((v - j.at(h)).abs() < 1e-9 * (1.0 + v.abs()), "{op:?} {a} {b} {v} {}", j.at(h));
        }
    }
}
