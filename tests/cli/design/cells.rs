//! `passivity design`: each wall of the table with the rate and encoder that it is for.

use serde_json::{Value, json};

use crate::harness::Dir;

/// The rates and encoders that are chosen without a list are those that are printed, in every form.
#[test]
fn every_cell_typed_with_the_rate_and_encoder_beside_it_is_passive() {
    let viscous =
        "[device]\nviscous = \"1.5 N s/m\"\n[sampling]\nRATE\n[wall]\nstiffness = \"K N/mm\"\n";
    let rotary = "[device]\nviscous = \"1.5e-3 N m s/rad\"\ncoulomb = \"1e-6 N m\"\n[sampling]\nRATE\n\
                  [encoder]\nENCODER\n[wall]\nstiffness = \"K N m/rad\"\n";
    let geared = rotary.replace(
        "[wall]",
        "side = \"motor\"\n[transmission]\nratio = \"7\"\n[wall]",
    );
    let fraction = "resolution = \"459056050/9156667748857 gon\"";
    let counts = "counts_per_revolution = \"1001\"";
    let mut cells = 0;
    for (scene, rate, encoder) in [
        (viscous, "rate = \"1234.567 Hz\"", ""),
        (viscous, "period = \"3/7001 s\"", ""),
        (viscous, "rate = \"1234.567 Hz ± 1%\"", ""),
        (viscous, "period = \"0.71 … 0.723456 ms\"", ""),
        (rotary, "rate = \"1234.567 Hz\"", fraction),
        (
            rotary,
            "rate = \"1 kHz\"",
            "resolution = \"0.01234567 deg ± 1%\"",
        ),
        (rotary, "rate = \"1 kHz\"", counts),
        (&geared, "rate = \"1234.567 Hz\"", fraction),
        (&geared, "rate = \"1234.567 Hz\"", counts),
    ] {
        let dir = Dir::new();
        let with = |rate: &str, encoder: &str, stiffness: &str| {
            let text = scene.replace("RATE", rate).replace("ENCODER", encoder);
            text.replace("K N", &format!("{stiffness} N"))
        };
        let file = dir.write("own.toml", with(rate, encoder, "1"));
        let table = dir.run(&["design", &file, "--format", "json"]).json();
        let csv = dir.run(&["design", &file, "--format", "csv"]).stdout;
        let people = dir.run(&["design", &file]).stdout;
        let list = |name: &str| table[name].as_array().cloned().expect("a list");
        let text = |setting: &Value| setting["text"].as_str().expect("a text").to_owned();
        let typed = |line: &str, text: &str| {
            let key = line.split(' ').next().expect("a key");
            let text = text.trim_end_matches(" at the motor");
            format!("{key} = \"{text}\"")
        };
        let encoders = match list("encoders") {
            none if none.is_empty() => vec![json!({ "text": "", "is_now": true })],
            some => some,
        };
        for settings in [&list("rates"), &encoders] {
            let own: Vec<_> = settings.iter().filter(|s| s["is_now"] == true).collect();
            assert_eq!(own.len(), 1, "{rate} {encoder}");
        }
        for (own, line) in [(list("rates"), rate), (encoders.clone(), encoder)] {
            let own = own.iter().find(|s| s["is_now"] == true).map(text);
            let own = own.unwrap_or_default();
            assert!(
                line.contains(own.trim_end_matches(" at the motor")),
                "{line}: {own}"
            );
        }
        for (row, rate_cells) in list("rates").iter().zip(list("stiffest")) {
            for (column, cell) in encoders.iter().zip(rate_cells.as_array().expect("cells")) {
                let (row, column) = (text(row), text(column));
                let stiffness = cell["typed"].as_str().expect("a wall");
                let scene = with(&typed(rate, &row), &typed(encoder, &column), stiffness);
                assert_eq!(
                    dir.check(&scene).text("verdict"),
                    "passive",
                    "{row} {column}: {scene}"
                );
                assert!(
                    csv.contains(&format!("\n{row},{column},{stiffness},")),
                    "{csv}"
                );
                assert!(
                    people.contains(&row) && people.contains(&column),
                    "{people}"
                );
                cells += 1;
            }
        }
    }
    // Six rates each, and six encoders, of 1001 counts four: a half and a quarter of them is none.
    assert_eq!(cells, 6 * (4 + 6 + 6 + 4 + 6 + 4));
}

#[test]
fn what_the_scene_file_cannot_write_has_no_cell() {
    let dir = Dir::new();
    let text = "[device]\nviscous = \"1e-6 N m s/rad\"\ncoulomb = \"1e-3 N m\"\n[sampling]\nrate = \"9e500 Hz\"\n\
                [encoder]\ncounts_per_revolution = 400000000000\n[wall]\nstiffness = \"1 N m/rad\"\n";
    let scene = dir.write("far.toml", text);
    let run = dir.run(&["design", &scene, "--format", "json"]);
    assert_ne!(run.code, 2, "{}", run.stderr);
    let table = run.json();
    let texts = |name: &str| -> Vec<String> {
        let list = table[name].as_array().expect("a list").iter();
        list.map(|s| s["text"].as_str().expect("a text").to_owned())
            .collect()
    };
    assert_eq!(texts("rates"), ["2.25e500 Hz", "4.5e500 Hz", "9e500 Hz"]);
    let counts = [
        "100000000000",
        "200000000000",
        "400000000000",
        "800000000000",
    ];
    assert_eq!(texts("encoders"), counts);
}
