//! Finds the peers that are not crates. What is not there is left out: a build never fails for want of a peer.

use std::env;
use std::fs;
use std::process::Command;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(gsl, boost)");
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=shim/boost.cpp");
    println!("cargo::rerun-if-changed=../Cargo.lock");
    println!("cargo::rerun-if-env-changed=PKG_CONFIG_PATH");
    find_gsl();
    build_boost();
    for name in ["spec_math", "ode_solvers"] {
        let version = locked_version(name).unwrap_or_else(|| "unknown".into());
        println!("cargo::rustc-env=PEER_{}={version}", name.to_uppercase());
    }
    let rustc = env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    println!("cargo::rustc-env=RUSTC_VERSION={}", output(&rustc, &["--version"]).unwrap_or_default());
}

/// Standard output of a command that ran and succeeded.
fn output(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
}

/// `cfg(gsl)` and the linker's arguments where `pkg-config` or `gsl-config` knows the library.
fn find_gsl() {
    let Some(flags) = output("pkg-config", &["--libs", "gsl"]).or_else(|| output("gsl-config", &["--libs"])) else {
        return;
    };
    for flag in flags.split_whitespace() {
        if let Some(path) = flag.strip_prefix("-L") {
            println!("cargo::rustc-link-search=native={path}");
        } else if let Some(library) = flag.strip_prefix("-l") {
            println!("cargo::rustc-link-lib={library}");
        }
    }
    println!("cargo::rustc-cfg=gsl");
}

/// `cfg(boost)` where the shim compiles, that is where a C++ compiler and the headers are.
fn build_boost() {
    let mut shim = cc::Build::new();
    shim.cpp(true).file("shim/boost.cpp").opt_level(3).warnings(false).cargo_warnings(false);
    // The same instruction set as the Rust code it is compared with.
    if env::var("CARGO_CFG_TARGET_FEATURE").is_ok_and(|features| features.split(',').any(|one| one == "avx2")) {
        shim.flag_if_supported("-march=x86-64-v3");
    }
    if shim.try_compile("pendula_boost").is_ok() {
        println!("cargo::rustc-cfg=boost");
    }
}

/// The version of a crate in the lock file.
fn locked_version(name: &str) -> Option<String> {
    let lock = fs::read_to_string("../Cargo.lock").ok()?;
    let entry = lock.split("[[package]]").find(|entry| entry.contains(&format!("name = \"{name}\"\n")))?;
    let line = entry.lines().find_map(|line| line.strip_prefix("version = "))?;
    Some(line.trim_matches('"').to_owned())
}
