use passivity_scene::Scene;
use passivity_sim::{report::Simulation, trace::Table, *};
fn main() {
    let out = std::env::args().nth(1).unwrap();
    let mut files: Vec<_> = std::fs::read_dir("/work/main/scenes")
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "toml"))
        .collect();
    files.sort();
    for f in files {
        let name = f.file_stem().unwrap().to_string_lossy().into_owned();
        let scene = match Scene::read(&f) {
            Ok(s) => s,
            Err(e) => {
                eprintln!("{name}: unreadable {}", e.render(false));
                continue;
            }
        };
        let mut point = scene.point();
        point.intervals = 300;
        for m in ["closed-form", "exact", "enclosure", "reference"] {
            let method = Method::parse(m).unwrap();
            let base = format!("{out}/sim-{name}-{m}");
            let go = || -> Result<(), SimError> {
                let plan = Plan::compile(&point)?;
                let table = Table::new(&point, &method);
                let mut text = table.header() + "\n";
                let mut failed = None;
                let mut see = |line: &Line<'_>| match table.write(line, &mut text) {
                    Ok(()) => true,
                    Err(e) => {
                        failed = Some(e);
                        false
                    }
                };
                let run = simulate(&point, &method, Some(&mut see))?;
                if let Some(e) = failed {
                    return Err(e);
                }
                let report = Simulation::new(&scene.name, &plan, &method, &run, 0.0)?;
                std::fs::write(format!("{base}.csv"), text).unwrap();
                std::fs::write(
                    format!("{base}.json"),
                    serde_json::to_string_pretty(&report).unwrap(),
                )
                .unwrap();
                Ok(())
            };
            let text = match go() {
                Ok(()) => String::new(),
                Err(e) => format!("error: {e}\n"),
            };
            std::fs::write(format!("{base}.err"), text).unwrap();
        }
    }
    // the sweep of golden.sh
    let scene = Scene::read("/work/main/scenes/dimensionless.toml").unwrap();
    let point = scene.point();
    let range = |t| sweep::Range::parse(t).unwrap();
    let grid = sweep::Grid::new(range("0:1:9"), range("0:1.5:9"), range("1,2,5")).unwrap();
    let path = std::path::PathBuf::from(format!("{out}/grid.csv"));
    let _ = std::fs::remove_file(&path);
    let mut opened = sweep::open(&path, &point, &grid, false).unwrap();
    let mut rows = vec![None; grid.len()];
    sweep::run(&point, &grid, &[], |i, r| {
        rows[i] = Some(r);
        opened.rows.add(&grid, i, &r)
    })
    .unwrap();
    opened.rows.finish(&grid, &rows).unwrap();
}
