"""The functions of `import tracking`: a module each, thin, over the packages below."""
