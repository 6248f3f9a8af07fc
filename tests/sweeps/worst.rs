//! The worst inputs that a search has found for each node stay within the node's bound.

use std::collections::BTreeMap;
use std::path::Path;

use crate::support::eval::{renderer, told};
use crate::support::ledger::{Ledger, ProofKey};
use crate::support::wait::block_on;
use chiaro::diag::Diagnostic;
use chiaro::files::Disk;
use chiaro::library::Library;
use chiaro::sweeps::{Case, Laboratory, WorstInput, bound, search};

#[test]
fn the_worst_inputs_stay_within_their_bounds() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/worst");
    let mut by_case: BTreeMap<Case, Vec<WorstInput>> = BTreeMap::new();
    for file in std::fs::read_dir(folder).expect("the folder is there").flatten() {
        for worst in search::read(&Disk, &file.path()).unwrap_or_else(|problem| panic!("{problem}"))
        {
            by_case.entry(worst.case.clone()).or_default().push(worst);
        }
    }
    assert!(by_case.len() > 150, "only {} cases are kept", by_case.len());
    let mut renderer = renderer();
    let mut lab = Laboratory::new(Library::built_in(), &mut renderer)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)));
    let mut ledger = Ledger::open("worst");
    for (case, kept) in by_case {
        let bench = lab.bench(&case).unwrap_or_else(|problems| panic!("{}", told(&problems)));
        let all: Vec<_> = kept
            .iter()
            .map(|worst| worst.numbers(&bench).unwrap_or_else(|problem| panic!("{problem}")))
            .collect();
        let mut key = ProofKey::of_judges(&["tests/sweeps/worst.rs"])
            .with(lab.renderer.gpu().info.driver_info.as_bytes());
        let content = lab.content_of(&bench, &all, &mut |bytes| key.add(bytes));
        content.unwrap_or_else(|problems| panic!("{}", told(&problems)));
        ledger.prove(&format!("{}, {:?}", case.name(), case.tier), &key, || {
            let findings = block_on(lab.compare(&bench, &all));
            let findings = findings.map_err(|stopped| told(&Vec::<Diagnostic>::from(stopped)))?;
            let most = bound(&case, &lab.library);
            for (finding, worst) in findings.iter().zip(&kept) {
                let is_finite = finding.got.iter().all(|x| x.is_finite());
                if !is_finite || finding.error > most {
                    return Err(format!(
                        "{:.1e} of {most:.0e}, was {:.1e}: {finding:?}",
                        finding.error, worst.error
                    ));
                }
            }
            // The figure is the verdict alone: many of these inputs are denormal, and threads
            // differ in whether those count as 0.
            Ok(0.0)
        });
    }
    ledger.close();
}
