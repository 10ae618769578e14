//! x
use sml_tests::{families, fast, random, corpus};
fn main() {
    let args: Vec<String> = std::env::args().collect();
    if args[1] == "random" || args[1]=="corpus" {
        let texts: Vec<(String,String)> = if args[1]=="random" {(0..args[2].parse().unwrap()).map(|s| (format!("{s}"), random::specification(s, random::Options::default()))).collect()} else { corpus::all().into_iter().map(|e| (e.name, e.text)).collect() };
        let (mut a, mut b, mut early_r, mut early_u, mut r, mut u, mut rs, mut us) = (0,0,0,0,0,0,(0,0),(0,0));
        for (seed, text) in texts {
            let Ok(spec) = fast::resolved(&text) else {continue};
            for classic in [false,true] {
            let o = fast::options(classic, 20000);
            let Ok(s) = fast::solved(&spec, &o) else {continue};
            let full = s.figures();
            let v = synth_core::verdict::verdict(&spec, o.semantics, &o.limits).unwrap();
            assert_eq!(v.realizable, full.realizable, "{seed}\n{text}");
            a += full.states; b += v.explored;
            if args[1]=="corpus" { println!("{seed} {} {} {}", full.realizable, full.states, v.explored); }
            if v.realizable { r += 1; rs.0+=full.states; rs.1+=v.explored; if v.explored + 2 < full.states { early_r += 1;} } else {u+=1; us.0+=full.states; us.1+=v.explored; if v.explored+2<full.states {early_u+=1;}}
            }
        }
        println!("{a} {b}; realizable {early_r}/{r} {rs:?}, unreal {early_u}/{u} {us:?}");
        return;
    }
    for a in args[1..].chunks(3) {
        let mut text = (families::by_name(&a[0]).unwrap().text)(a[1].parse().unwrap());
        match &*a[2] {
            "eventually" => text = text.replace("urgent controller", "eventually controller"),
            "noqueue" => { let at = text.find("    assumption scenario NoQueue").unwrap(); let end = at + text[at..].find("]").unwrap(); text.replace_range(at..=end, ""); }
            "nopress" => { let at = text.find("    assumption scenario Presses").unwrap(); let end = at + text[at..].find("\n").unwrap(); text.replace_range(at..=end, ""); }
            "-" => {}
            other => if let Some((old, new)) = other.split_once("=>") { assert!(text.contains(old)); text = text.replace(old, new); } else { let at = text.find(&format!("assumption scenario {}", a[2])).unwrap(); let end = at + text[at..].find("}").unwrap(); text.replace_range(at..=end, ""); },
        }
        let spec = fast::resolved(&text).unwrap();
        let t = std::time::Instant::now();
        let o = fast::options(false, 3_000_000);
        let v = synth_core::verdict::verdict(&spec, o.semantics, &o.limits);
        let t = t.elapsed();
        println!("{} {} {} {:.200} {:?}", a[0], a[1], a[2], format!("{v:?}"), t);
        let t = std::time::Instant::now();
        let s = fast::solved(&spec, &o);
        println!("   full {} {:?}", s.map_or(format!("error"), |s| format!("{:?}", s.figures())), t.elapsed());
    }
}
