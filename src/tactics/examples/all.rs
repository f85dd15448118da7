fn main() {
    let (mut yes, mut no, mut bytes) = (0, 0, 0usize);
    for path in std::env::args().skip(1) {
        let Ok(d) = derivation::load(std::path::Path::new(&path)) else { println!("{path}: unreadable"); continue };
        for claim in &d.claims {
            if let Ok(only) = std::env::var("ONLY") && claim.name() != only { continue }
            let begun = std::time::Instant::now();
            let found = rederive_tactics::record(&d, claim);
            let ms = begun.elapsed().as_millis();
            match found {
                Ok(proofs) => {
                    yes += 1;
                    let mut out = String::new();
                    for p in &proofs {
                        let shown = checker::replay(&p.sequent, &p.steps).unwrap();
                        bytes += serde_json::to_string(p).unwrap().len();
                        out += &format!(" [{} steps, leaves out {}, 2^{}]", shown.steps(), shown.leaves_out().len(), shown.log2_error());
                    }
                    println!("yes {path} {} {ms} ms{out}", claim.name());
                }
                Err(why) => { no += 1; println!("no  {path} {} {ms} ms: {why}", claim.name()); }
            }
        }
    }
    println!("{yes} {no} {bytes} bytes");
}
