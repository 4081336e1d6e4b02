//! A WGSL text made into compute pipelines that share one layout of bindings.

use std::collections::HashMap;

use crate::{Device, Error, Result, wgsl};

/// What a binding of group 0 is; its number is its place in the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Slot {
    /// A storage buffer that is only read.
    Read,
    /// A storage buffer that is read and written.
    ReadWrite,
    /// A uniform buffer.
    Uniform,
}

impl Slot {
    fn layout(self, binding: usize) -> wgpu::BindGroupLayoutEntry {
        let ty = match self {
            Self::Read => wgpu::BufferBindingType::Storage { read_only: true },
            Self::ReadWrite => wgpu::BufferBindingType::Storage { read_only: false },
            Self::Uniform => wgpu::BufferBindingType::Uniform,
        };
        wgpu::BindGroupLayoutEntry {
            binding: binding as u32,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
            count: None,
        }
    }
}

/// What was compiled, by its text: a device compiles no text twice.
pub(crate) type Cache = HashMap<String, Compiled>;

/// A layout of bindings, and the pipelines that share it by the names of their entry points.
#[derive(Debug, Clone)]
pub(crate) struct Compiled {
    layout: wgpu::BindGroupLayout,
    pipelines: Vec<wgpu::ComputePipeline>,
}

/// `N` entry points of one WGSL text.
#[derive(Debug, Clone)]
pub(crate) struct Program<const N: usize> {
    name: String,
    layout: wgpu::BindGroupLayout,
    pipelines: [wgpu::ComputePipeline; N],
}

impl<const N: usize> Program<N> {
    /// Compiles the text. A refusal of the text is [`Error::Shader`].
    pub fn new(device: &Device, name: &str, text: &str, slots: &[Slot], entries: [&str; N]) -> Result<Self> {
        let refused = |error| match error {
            Error::Refused { message, .. } => Error::Shader { kernel: name.to_owned(), message },
            other => other,
        };
        device.healthy()?;
        let key = format!("{}\n{text}", entries.join(" "));
        let known = device.programs().get(&key).cloned();
        let compiled = match known {
            Some(compiled) => compiled,
            None => {
                let compiled = compile(device, name, text, slots, &entries).map_err(refused)?;
                device.programs().insert(key, compiled.clone());
                compiled
            }
        };
        let Compiled { layout, pipelines } = compiled;
        let pipelines = pipelines.try_into().map_err(|_| {
            refused(Error::Refused { doing: format!("compiling `{name}`"), message: "pipelines are missing".into() })
        })?;
        Ok(Self { name: name.to_owned(), layout, pipelines })
    }

    /// Binds buffers, in the order of the slots.
    pub fn bind(&self, device: &Device, buffers: &[&wgpu::Buffer]) -> Result<wgpu::BindGroup> {
        device.checked(&format!("binding the buffers of `{}`", self.name), || {
            let entries: Vec<_> = buffers
                .iter()
                .enumerate()
                .map(|(binding, buffer)| wgpu::BindGroupEntry {
                    binding: binding as u32,
                    resource: buffer.as_entire_binding(),
                })
                .collect();
            device.raw().create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some(&self.name),
                layout: &self.layout,
                entries: &entries,
            })
        })
    }

    /// Runs one entry point with at least `items` threads.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>, entry: usize, bound: &wgpu::BindGroup, items: u32) {
        let [x, y, z] = wgsl::workgroups(items);
        pass.set_pipeline(&self.pipelines[entry]);
        pass.set_bind_group(0, bound, &[]);
        pass.dispatch_workgroups(x, y, z);
    }
}

fn compile(device: &Device, name: &str, text: &str, slots: &[Slot], entries: &[&str]) -> Result<Compiled> {
    let raw = device.raw();
    let doing = format!("compiling `{name}`");
    // In two steps, so that an error in the text is reported and not that its pipeline has no text.
    let module = device.checked(&doing, || {
        raw.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(name),
            source: wgpu::ShaderSource::Wgsl(text.into()),
        })
    })?;
    device.checked(&doing, || {
        let bindings: Vec<_> = slots.iter().enumerate().map(|(binding, slot)| slot.layout(binding)).collect();
        let layout =
            raw.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(name), entries: &bindings });
        let pipeline_layout = raw.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(name),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = |entry: &&str| {
            raw.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(entry),
                layout: Some(&pipeline_layout),
                module: &module,
                entry_point: Some(entry),
                compilation_options: wgpu::PipelineCompilationOptions {
                    // Every kernel writes its workgroup memory before it reads it.
                    zero_initialize_workgroup_memory: false,
                    ..Default::default()
                },
                cache: None,
            })
        };
        let pipelines = entries.iter().map(pipeline).collect();
        Compiled { layout, pipelines }
    })
}
