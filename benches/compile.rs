//! Benchmark of compilation: chains of math nodes, from document to WGSL, with naga's share apart.
//!
//! `cargo bench` prints the times; docs/performance.md holds the figures.

use std::hint::black_box;

use chiaro::compile::{CompileOptions, Live, check, compile, compile_source};
use chiaro::document::{Endpoint, Look, Node, Wire};
use chiaro::library::Library;
use chiaro::wgsl;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// A chain of `count` math nodes over the surface's facing ratio, which nothing can fold.
fn chain(count: usize) -> Look {
    let mut look = Look { name: "Chain".to_owned(), ..Look::default() };
    let mut add = |id: String, kind: &str| {
        look.graph
            .nodes
            .insert(id.as_str().into(), Node { kind: kind.to_owned(), ..Node::default() });
    };
    add("facing".to_owned(), "facing");
    for i in 0..count {
        add(format!("n{i}"), if i % 2 == 0 { "add" } else { "multiply" });
    }
    add("output".to_owned(), "output");
    let mut from = "facing".to_owned();
    for i in 0..count {
        let id = format!("n{i}");
        let value = chiaro::document::Value::Number(if i % 2 == 0 { 0.001 } else { 0.999 });
        look.graph.nodes[id.as_str()].values.insert("b".into(), value);
        look.graph
            .wires
            .push(Wire { from: Endpoint::new(from, ""), to: Endpoint::new(id.clone(), "a") });
        from = id;
    }
    look.graph
        .wires
        .push(Wire { from: Endpoint::new(from, ""), to: Endpoint::new("output", "color") });
    look
}

fn benchmark(criterion: &mut Criterion) {
    let library = Library::built_in();
    let mut group = criterion.benchmark_group("chain");
    group.sample_size(10);
    for count in [200, 2_000, 20_000] {
        let look = chain(count);
        let text = look.to_text();
        group.bench_with_input(BenchmarkId::new("read", count), &text, |b, text| {
            b.iter(|| Look::read(black_box(text), "chain.json"));
        });
        for live in [Live::Keyed, Live::All] {
            let options = CompileOptions { live: live.clone(), ..CompileOptions::default() };
            group.bench_with_input(
                BenchmarkId::new(format!("our own time, {live:?}"), count),
                &look,
                |b, look| {
                    b.iter(|| {
                        let typed = check(black_box(look), library, None)
                            .expect("the chain is valid")
                            .value;
                        compile_source(&typed, &options).expect("the chain compiles")
                    });
                },
            );
        }
        let source = compile(&look, library, &CompileOptions::default())
            .expect("the chain compiles")
            .value
            .wgsl;
        group.bench_with_input(
            BenchmarkId::new("naga parses and validates", count),
            &source,
            |b, source| {
                b.iter(|| wgsl::parse(black_box(source)));
            },
        );
    }
    group.finish();
}

criterion_group!(benches, benchmark);
criterion_main!(benches);
